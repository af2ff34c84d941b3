// su_queue: a first-in first-out store in an sram whose first word falls through.
//
// Idea    The sram's own output register shows the head and holds it until it is taken; in that cycle the next word is
//         read, so a deep and wide queue costs two pointers and no flip-flops for its words.
// Stream  in: refused only when Depth words wait behind the head. out: the same words in order.
// Pace    One beat per cycle in and out; a word is seen at the output two cycles after it was put in.
// Model   std::queue.

module su_queue #(
  parameter int unsigned DataW = 32,
  parameter int unsigned Depth = 16,  // a power of two
  localparam int unsigned PtrW = $clog2(Depth)
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [DataW-1:0] in_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [DataW-1:0] out_o,

  output logic             empty_o
);

  logic [PtrW-1:0] head_q, tail_q;
  logic [PtrW:0]   stored_q;  // words behind the head
  logic            valid_q;   // the sram shows the head
  logic            push, read;

  assign in_ready_o  = stored_q != (PtrW+1)'(Depth);
  assign out_valid_o = valid_q;
  assign empty_o     = !valid_q && stored_q == '0;
  assign push        = in_valid_i && in_ready_o;
  assign read        = stored_q != '0 && (!valid_q || out_ready_i);

  sram #(.DataW(DataW), .Depth(Depth)) u_words (
    .clk_i, .write_i(push), .waddr_i(tail_q), .wdata_i(in_i), .read_i(read), .raddr_i(head_q), .rdata_o(out_o)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      head_q   <= '0;
      tail_q   <= '0;
      stored_q <= '0;
      valid_q  <= 1'b0;
    end else begin
      if (push) tail_q <= tail_q + 1'b1;
      if (read) head_q <= head_q + 1'b1;
      if (push && !read) stored_q <= stored_q + 1'b1;
      if (read && !push) stored_q <= stored_q - 1'b1;
      valid_q <= read || (valid_q && !out_ready_i);
    end
  end

endmodule
