# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# The table of proofs, read by synth/prove.sh. The comment above a proof says what its parameters mean.
#
# proof  NAME MODULES PARAMETERS     MODULES: the first is the top; `a+b` is module a with the checker b_proof.svh at
#        its end, `a+` with its own (named without the prefix pipegs_); free_a stands for module a. PARAMETERS: sets of
#        Name=value, with @settings where a package is read (@default: the machine as it is) and %Name=value for a
#        constant changed in it; or `machine`, see prove.sh
# mutant WHAT CHANGE [PARAMETERS]    of the top of the proof above; a trace of at most 16 cycles refutes it. CHANGE: of
#        sed -E;
#        PARAMETERS: else the first set

# --- rtl/lib ----------------------------------------------------------------------------------------------------------
# Every bit of a word travels by itself, so a few bits stand for all widths.
proof  skid "pipegs_skid+" "DataW=1; DataW=8; DataW=64"
mutant "the spare register is overwritten" 's/in_ready_o && in_valid_i\) spare_q/in_valid_i) spare_q/'
mutant "the spare register is never emptied" 's/(spare_valid_q <= )!out_free \&\& /\1/'
mutant "the spare beat is lost" 's/spare_valid_q \? spare_q : in_i/in_i/'

# Small rings of every kind: one word, powers of two, others; then every depth of the machine.
proof  fifo "pipegs_fifo+" "DataW=2 Depth=2; DataW=2 Depth=1; DataW=2 Depth=3; DataW=2 Depth=5; DataW=2 Depth=8;
       DataW=2 Depth=13"
mutant "accepts a word when full" 's/in_valid_i \&\& in_ready_o/in_valid_i/'
mutant "gives a word when empty" 's/out_valid_o \&\& out_ready_i/out_ready_i/'
mutant "counts upwards when a word leaves" 's/(if \(pop \&\& !push\) count_q <= count_q) - /\1 + /'
mutant "the tail turns one place early" 's/(tail_q == PtrW.\(Depth) - 1/\1 - 2/' "DataW=1 Depth=3"
proof  fifo_machine "pipegs_fifo+" "machine DataW=2"
mutant "shows the word at the tail" 's/words_q\[head_q\]/words_q[tail_q]/' "DataW=512 Depth=4"

# Memory: a word and a bit of the solver's choice; sizes up to 64 words of 8 bits, and 1024 of one.
proof  sram "pipegs_sram+" "DataW=1 Depth=2; DataW=3 Depth=5; DataW=8 Depth=64; DataW=1 Depth=1024"
mutant "the output changes without a read" 's/if \(read_i\) //'
mutant "a word that is written shows whatever is read" \
       's/words_q\[raddr_i\]/write_i ? wdata_i : words_q[raddr_i]/'

proof  arbiter \
       "pipegs_arbiter+ pipegs_round_robin pipegs_first_set" \
       "Ports=3; Ports=1; Ports=2; Ports=4; Ports=5; Ports=6; Ports=7; Ports=8"
mutant "the port granted last comes first" "s/last_i\(last_q\)/last_i(last_q - 1'b1)/"
mutant "a shown grant moves" 's/locked_q \&\& request_i\[shown_q\]/0/'
mutant "all are granted" 's/grant_o\[port\] = request_i\[port\]/grant_o = request_i/'
mutant "the turn goes on from the wrong port" 's/last_q <= port/last_q <= shown_q/'
proof  arbiter_machine "pipegs_arbiter+ pipegs_round_robin pipegs_first_set" "machine"
mutant "the lowest port always comes first" "s/last_i\(last_q\)/last_i({PortW{1'b1}})/" "Ports=21"

# Jobs for lines with one item, two and four, in a small buffer.
proof  line_reader "pipegs_line_reader+ pipegs_fifo+ free_sram" \
       "@default %MemoryW=4 %AddressW=6 %BurstW=1 TagW=1 ItemW=2 ItemsPerLine=2 Lines=4 Jobs=2 IndexW=4 CountW=3;
  @default %MemoryW=4 %AddressW=6 %BurstW=2 TagW=1 ItemW=2 ItemsPerLine=1 Lines=4 Jobs=2 IndexW=4 CountW=3;
  @default %MemoryW=8 %AddressW=6 %BurstW=1 TagW=1 ItemW=2 ItemsPerLine=4 Lines=4 Jobs=2 IndexW=5 CountW=4;
  @default %MemoryW=8 %AddressW=6 TagW=2 ItemW=4 ItemsPerLine=2 Lines=64 Jobs=8 IndexW=6 CountW=5"
mutant "asks without credits" 's/(asks_q <= left) \&\& places/\1/'
mutant "an answer that is used frees no place at once" 's/load \? free_both : free_issue/free_issue/'
mutant "a credit comes back with the answer" 's/else if \(load\) credits_q/else if (rsp_valid_i) credits_q/'
mutant "the address asked for goes on before it is taken" 's/else if \(issue\) line_q/else line_q/'
mutant "one credit for all lines of a request" "s/(credits_q <= credits_q) - CreditW'\(mem_lines_o\)/\1/"
mutant "a request leaves its group" 's/(assign rest  .*= ).*/\1 BurstW\x27(2**BurstW - 1);/'
mutant "the line behind the table's last one is asked for" "s/MostW'\(lines_end\) >/MostW'(lines_end) > 1 +/"
mutant "a job behind a bad one is taken" 's/ \&\& !bad_q;/;/'
mutant "items go on behind the last" 's/item_q \+ 1.b1 == job_count/item_q == job_count/'
mutant "a job of nothing is taken" "s/job_count_i == '0 \|\| //"

# --- rtl/buf ----------------------------------------------------------------------------------------------------------
# Small rings on the real SRAM, then every depth of the machine on free_sram.
proof  sram_fifo "pipegs_sram_fifo+ pipegs_sram+" "DataW=2 Depth=2; DataW=2 Depth=3; DataW=2 Depth=5; DataW=2 Depth=8;
       DataW=2 Depth=13"
mutant "accepts a word when full" 's/in_valid_i \&\& in_ready_o/in_valid_i/'
mutant "counts without the head" 's/stored_q \+ CountW.\(out_valid_q\)/stored_q/'
mutant "fetches over a head that was not taken" 's/\(!out_valid_q \|\| out_ready_i\)/1/'
mutant "writes at the head" 's/\.waddr_i\(tail_q\)/.waddr_i(head_q)/'
proof  sram_fifo_machine "pipegs_sram_fifo+ free_sram" "machine DataW=2"
mutant "the head is forgotten before it is taken" 's/else if \(out_ready_i\)/else/' "DataW=512 Depth=32"

# The ports of the default machine, of the one with lists, and of smaller ones.
proof  memory_arbiter "pipegs_memory_arbiter+ pipegs_arbiter+ pipegs_round_robin pipegs_first_set" \
       "@units=1 %MemoryW=8; @units=2 %MemoryW=8; @default %MemoryW=8;
       @order=1 %MemoryW=8"
mutant "a shown request is overwritten" 's/\(!out_valid_q \|\| mem_ready_i\)/1/'
mutant "takes requests though it is stopped" 's/ \&\& !stop_i//'
mutant "the shown request changes" 's/if \(take\) request_q <= out/request_q <= out/'
mutant "the data of a shown write changes" 's/if \(take \&\& out.write\)/if (out.write)/'
mutant "no class goes first" 's/(assign request = ).*/\1others;/'
mutant "geometry goes before colours" 's/(assign second  = ).*/\1others;/'
mutant "geometry follows geometry at once" 's/(assign able    = ).*/\1{Ports{1\x27b1}};/'
mutant "geometry keeps away for a cycle too few" 's/pause_q <= out.lines;/pause_q <= out.lines >> 1;/'
mutant "a grant leaves a port that waits" 's/if \(request != .0 \&\& moves\) grant_q/if (request != 0) grant_q/'
mutant "an answer goes to the port beside it" 's/mem_rsp_tag_i == /(mem_rsp_tag_i | 1) == /'
mutant "the tag names another port" 's/(TagW.\(port_q)\)/\1 ^ 1)/'
mutant "the halves are those of all ports" 's/ \| \{pipegs_pkg::HalvesW\{!grant_q\[i\]\}\}//'

# The ports of the machine's stores; then the lines in small ones, with slots in and out of order.
proof  alpha_store \
       "pipegs_alpha_store+ pipegs_arbiter+ pipegs_round_robin pipegs_first_set pipegs_slot_pool free_sram_fifo
  free_sram" \
       "@default; @units=2; @units=1"
mutant "the answer goes to all who ask" 's/(asked_q +<= )grant/\1read_valid_i/'
mutant "a line that is skipped is answered" 's/(asked_q +<= grant).*;/\1;/'
mutant "a line that is skipped keeps its slot" "s/(free_q +<= )read;/\1(grant \& ~read_skip_i) != 0;/"
mutant "the turn goes on only with a write" 's/\.advance_i\(1.b1\)/.advance_i(write_i)/' "@units=2"
proof  alpha_slots \
       "pipegs_alpha_store+alpha_slots pipegs_arbiter pipegs_round_robin pipegs_first_set free_slot_pool open_sram" \
       "@units=2,alpha_lines=64 %LineW=2 %AlphaLines=4 %AlphaSlotW=2 %AlphaAddresses=8;
  @units=1,alpha_lines=64 %LineW=2 %AlphaLines=3 %AlphaSlotW=2 %AlphaAddresses=8"
mutant "reads at the address that is written" 's/raddr_i\(read_address\[RingW-1:0\]\)/raddr_i(address_i[RingW-1:0])/'
mutant "the slot that is free is the one that is written" 's/free_slot_i\(read_slot\)/free_slot_i(write_slot)/'
mutant "a line lies at its address" "s/waddr_i\(write_slot\)/waddr_i(SlotW'(address_i))/"

# The double buffer of Fig. 7: small on the real SRAM, then every buffer of the machine on free_sram, of each word eight
# bits.
proof  pixel_buffer "pipegs_pixel_buffer+ pipegs_sram+" "DataW=2 Words=2; DataW=2 Words=8"
mutant "the wrong half becomes fresh" 's/if \(half_q\) fresh_0_q/if (!half_q) fresh_0_q/'
mutant "both halves are written" 's/(write_i\(blend_write_i) \&\& !half_q/\1/'
mutant "a write makes the word of the other half valid" 's/(if \(blend_write_i) \&\& half_q\) fresh_1_q/\1) fresh_1_q/'
mutant "the resolver sees the blender's half" \
       's/resolve_rdata_o = half_q \? rdata_0 : rdata_1/resolve_rdata_o = half_q ? rdata_1 : rdata_0/'
proof  pixel_buffer_machine "pipegs_pixel_buffer+ free_sram" "machine DataW=8"
mutant "the halves do not change roles" 's/half_q <= !half_q/half_q <= half_q/'

# The pool of the default machine, and small ones.
proof  slot_pool "pipegs_slot_pool+ free_sram_fifo" "Slots=8; Slots=2; Slots=1024"
mutant "a slot never used is not counted" 's/if \(take \&\& fresh\) fresh_q/if (take \&\& fresh \&\& !free_i) fresh_q/'
mutant "the queue loses its head while new slots are left" \
       's/(slot_ready_i) \&\& !fresh\)/\1)/'
mutant "slots go on where they were when they are renewed" "s/if \(renew_i\) fresh_q <= '0;/if (1'b0) fresh_q <= '0;/"
mutant "a slot that comes back stays counted as used" 's/(if \(take != free_i)(\) used_q)/\1 \&\& fresh\2/'

# --- rtl/mem ----------------------------------------------------------------------------------------------------------
# Small queues, then that of the machine.
proof  axi_fence "pipegs_axi_fence+ free_queue" "DataW=2 Fenced=3 Writes=3; DataW=2 Fenced=3 Writes=1;
       DataW=4 Fenced=8 Writes=13; DataW=47 Fenced=64 Writes=64"
mutant "what waits leaves as soon as it shows" "s/since >= StampW'\(writes_i\)/1/"
mutant "one write too few is waited for" "s/since >= StampW'\(writes_i\)/since + StampW'(1) >= StampW'(writes_i)/"
mutant "a read passes others that wait" "s/waiting == '0 \&\& //"
mutant "a read passes while a write is unanswered" "s/ \&\& writes_i == '0//"
mutant "the head is withdrawn when its stamp is too old" 's/leaving_q \|\| //' "DataW=2 Fenced=3 Writes=1"
mutant "a read that is shown is replaced by one that is due" 's/ \&\& !passing_q;/;/'

# A line of one beat, of two and of four, with short words and addresses of a few pages.
proof  axi_write "pipegs_axi_write+ free_sram_fifo axi_check" \
       "@default %MemoryW=16 %AddressW=13 %TagW=2 %BusW=16 %AxiAddrW=16 AddrW=16 Writes=3;
  @default %MemoryW=16 %AddressW=13 %TagW=2 %BusW=8 %AxiAddrW=16 AddrW=16 Writes=3;
  @default %MemoryW=32 %AddressW=13 %TagW=2 %BusW=8 %AxiAddrW=16 AddrW=16 Writes=3;
  @default %AddressW=10 %TagW=2 %BusW=128 %AxiAddrW=16 AddrW=16 Writes=3;
  @default %AddressW=10 %TagW=2 %BusW=512 %AxiAddrW=16 AddrW=16 Writes=3"
mutant "WLAST one beat early" 's/(data_last    = beat_q == BeatW.\(Beats) - 1/\1 - 2/' \
       "@default %MemoryW=32 %AddressW=13 %TagW=2 %BusW=8 %AxiAddrW=16 AddrW=16 Writes=3"
mutant "the address is written over while it waits" \
       's/address_free = !aw_valid_q \|\| m_axi_i.aw_ready/address_free = 1/'
mutant "the data is written over while it waits" 's/data_free    = !w_valid_q \|\| .*;/data_free = 1;/'
mutant "data shows before its address" 's/(if \(data_free\) w_valid_q <= )take/\1in_valid_i/'
mutant "AW is valid in reset" 's/aw_valid_q <= 1.b0/aw_valid_q <= 1/'
mutant "all beats leave from the top of the line" 's/data_q\[DataW-1:0\]/data_q[pipegs_pkg::MemoryW-1 -: DataW]/' \
       "@default %MemoryW=16 %AddressW=13 %TagW=2 %BusW=8 %AxiAddrW=16 AddrW=16 Writes=3"
mutant "strobes only on the lowest byte of a half" \
       's/\{\(GrainW\/8\)\{written_q\[i\]\}\}/(GrainW\/8)\x27(written_q[i])/' \
       "@default %AddressW=10 %TagW=2 %BusW=512 %AxiAddrW=16 AddrW=16 Writes=3"
mutant "a half that is not written is" "s/in_halves_i\[1\]/1'b1/"
mutant "the strobes do not move with the data" 's/written_q >> StepW/written_q/' \
       "@default %MemoryW=16 %AddressW=13 %TagW=2 %BusW=8 %AxiAddrW=16 AddrW=16 Writes=3"
mutant "a burst that is not INCR" 's/(aw.burst = )pipegs_pkg::AxiIncr/\12\x27b10/'
mutant "beats that leave do not count as moving" 's/ \|\| \(w_valid_q \&\& m_axi_i.w_ready\)//'
mutant "a line is taken without room" 's/in_ready_o   = room \&\& /in_ready_o = /'
mutant "the page of the base is not added" 's/base_i\[AddrW-1:12\] \+ //'

# Short words, then lines of the machine at each width of the bus.
proof  axi_gather "pipegs_axi_gather+ free_sram" "@default %MemoryW=4 %MemoryPorts=3 %TagW=2 DataW=4;
       @default %MemoryW=4 %MemoryPorts=3 %TagW=2 DataW=2; @default %MemoryW=8 %MemoryPorts=3 %TagW=2 DataW=2;
       @default DataW=512; @default DataW=256; @default DataW=128"
mutant "one counter for all tags" 's/port = beat_tag_i\[PortW-1:0\]/port = 0/' \
       "@default %MemoryW=8 %MemoryPorts=3 %TagW=2 DataW=2"
mutant "a counter goes on in the next epoch" 's/else if \(turn_i\) beats_q <= .0;//' \
       "@default %MemoryW=8 %MemoryPorts=3 %TagW=2 DataW=2"
mutant "a line of the old epoch shows" 's/line_valid_q \&\& !turn_i/line_valid_q/'
mutant "the last beat goes to the lowest place" 's/line_o = \{last_q, parts\}/line_o = {parts, last_q}/' \
       "@default %MemoryW=8 %MemoryPorts=3 %TagW=2 DataW=2"

proof  axi_read "pipegs_axi_read+ pipegs_axi_gather free_sram axi_check" \
       "@default %MemoryW=16 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=16 %AxiAddrW=16 AddrW=16 Reads=3;
  @default %MemoryW=16 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3;
  @default %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3;
  @record=48 %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=32 %AxiAddrW=16 AddrW=16 Reads=3;
  @record=48 %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3"
mutant "the other half of the line" "s/halves == 2'b10/halves == 2'b01/" \
       "@record=48 %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=32 %AxiAddrW=16 AddrW=16 Reads=3"
mutant "all beats of half a line" "s/halves != '1 \? 8'\(HalfBeats - 1\) : //" \
       "@record=48 %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3"
mutant "the address is written over while it waits" 's/free       = !ar_valid_q \|\| m_axi_i.ar_ready/free = 1/'
mutant "one beat too many" "s/ - 8'd1;/;/"
mutant "beats of half the bus" 's/(DataW) \/ 8\)\);$/\1 \/ 16));/' \
       "@default %MemoryW=32 %AddressW=13 %TagW=1 %MemoryPorts=2 %BusW=16 %AxiAddrW=16 AddrW=16 Reads=3"
mutant "one read too many" "s/room_o           = reads_q != .*;/room_o = 1;/"
mutant "drained although the old core's reads are out" 's/(if \(turn\) old_q <= ).*/\1 0;/'
mutant "answers to the new core are counted as old ones" 's/(else if \(answered) \&\& !now\)/\1 \&\& old_q != 0)/'
mutant "drained in the cycle of the turn" "s/turn \? reads_q == '0 : old_q == '0/old_q == '0/"
mutant "a read that is not taken is not owed" "s/(out_q \+ ReadsW'\()in_valid_i \&\& free/\1asks/"
mutant "the line of a read that was answered is told" 's/answered \&\& m_axi_i.r.id == owed_id_q/0/'
mutant "the line is told with the base" 's/ - base_i\[AddrW-1:12\]//'
mutant "errors of the old core are told" 's/error_o          = now \&\& /error_o = m_axi_i.r_valid \&\& /'

proof  axi_manager \
       "pipegs_axi_manager+ pipegs_axi_fence pipegs_axi_read pipegs_axi_write pipegs_axi_gather
  free_sram free_sram_fifo axi_check" \
       "@default %MemoryW=16 %AddressW=13 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=16 %AxiAddrW=16 AddrW=16 Reads=3
  Writes=3 Fenced=2;
  @default %MemoryW=16 %AddressW=13 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3
  Writes=3 Fenced=2;
  @default %MemoryW=32 %AddressW=13 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=8 %AxiAddrW=16 AddrW=16 Reads=3
  Writes=3 Fenced=2;
  @default %AddressW=10 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=128 %AxiAddrW=16 AddrW=16 Reads=3 Writes=3 Fenced=2;
  @default %AddressW=10 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=512 %AxiAddrW=16 AddrW=16 Reads=3 Writes=3 Fenced=2;
  @record=48 %AddressW=10 %TagW=2 %MemoryPorts=3 %WritePorts=2 %BusW=512 %AxiAddrW=16 AddrW=16 Reads=3 Writes=3
  Fenced=2"
mutant "the fence does not see the writes" 's/writes_i\(writes\)/writes_i(writes ^ writes)/'
mutant "the last tag that may write is not fenced" 's/WritePorts\)\)/WritePorts) - 1)/'
mutant "a read is accepted without room" 's/ \&\& read_room;/;/'
mutant "idle while reads are out" "s/writes != '0 \|\| reads_pending/writes != '0/"
mutant "idle while writes are out" "s/writes != '0 \|\| reads_pending/reads_pending/"
mutant "a write is a read, too" 's/mem_valid_i \&\& !mem_request_i.write \&\& read_room/mem_valid_i \&\& read_room/'
mutant "of two errors in a cycle the read's is lost" \
       's/read_error \&\& read_decode/!write_error \&\& read_error \&\& read_decode/'
mutant "a write that nothing answers is told as one that failed" 's/write_error \&\& !write_decode/write_error/'
mutant "the line shown with an error is that of now" 's/(error_line_o = )error_line_q/\1write_line/'
mutant "errors are told in reset" "s/if \(!rst_ni\) error_q <= '0;/if (!rst_ni) error_q <= '1;/"
mutant "an answer counts before it is taken" 's/(answered_o *= m_axi_i.write.b_valid) \&\& m_axi_o.write.b_ready/\1/'

# --- rtl/control ------------------------------------------------------------------------------------------------------
proof  control_bus "pipegs_control_bus+ axi_lite_check" "@default"
mutant "an answer that was not taken is overwritten" 's/(!ar_ready_q \&\& )\(!r_valid_q \|\| s_axi_i.r_ready\)/\11/'
mutant "a write is done without its data" 's/(!aw_ready_q) \&\& !w_ready_q/\1/'
mutant "an address is taken over one that waits" 's/if \(aw_ready_q \&\& (s_axi_i.aw_valid\) aw_word_q)/if (\1/'
mutant "B falls before it was taken" 's/else if \(s_axi_i.b_ready\) b_valid_q/else b_valid_q/'
mutant "a read is not answered before the next one comes" 's/(read_o *= !ar_ready_q)/\1 \&\& s_axi_i.ar_valid/'
mutant "the data of a read changes while it waits" 's/if \(read_o\) begin/if (!ar_ready_q) begin/'

# A signed value over both words, addresses, and values that fill one word or two.
proof  control_slot "pipegs_control_slot+" "Word=128 Width=40 Signed=1; Word=130 Width=34 Shift=6; Width=32; Width=1;
       Width=28 Signed=1; Width=64; Width=12 Shift=6; Width=58 Shift=6 Signed=1"
mutant "strobes are not looked at" 's/(next .*write_data_i, write_data_i\}) \& mask/\1/'
mutant "a signed value reads without its sign" 's/64\{Signed \&\& /64{!Signed \&\& /'
mutant "addresses are kept in bytes" 's/next\[Shift \+: Width\]/next[0 +: Width]/' "Width=34 Shift=6"
mutant "a write of the low word reaches the high one" "s/(\{write_mask_i, )32'd0\}/\1write_mask_i}/"
mutant "a write beside the slot reaches it" 's/write_i \&\& write_hit/write_i/'

proof  control_shadow "pipegs_control_shadow+ pipegs_control_slot" "@units=1,antialias=1,tight_cull=1,world_w=32"
mutant "a queued frame can be written" 's/(write *= write_i) \&\& !queued_q/\1/'
mutant "a frame that was taken stays when a start comes" \
       's/else if \(frame_ready_i\)/else if (frame_ready_i \&\& !start_i)/'
mutant "a dropped frame is shown" 's/else if \(drop_i\)/else if (drop_i \&\& !queued_q)/'

proof  control_events "pipegs_control_events+" "@default %AddressW=6"
mutant "a clear wins over an event" \
       's/(error_next *= )\(error_q \& (~clear_error_i\[Causes:0\])\)( \| .*);/\1(error_q\3) \& \2;/'
mutant "a later error replaces the first address" "s/(error_i != '0) \&\& kept == '0/\1/"
mutant "of several causes the highest is shown" \
       's/int unsigned i = Causes; i > 0; i -= 1/int unsigned i = 1; i <= Causes; i += 1/'
mutant "the interrupt does not look at the mask" 's/irq_q \& enable_i\[2:0\]/irq_q/'
mutant "an address that is not known is shown" 's/ \& \{AddressW\{located_i\[i-1\]\}\}//'
mutant "a start while full raises no interrupt" "s/start_full_i \|\| error_i/error_i/"

proof  control_counters "pipegs_control_counters+" "@default %PerfW=36; @units=1 %PerfW=34"
mutant "the high word is that of now" 's/32.\(high_q\)/32'"'"'(count[PerfW-1:32])/'
mutant "a read of the high word keeps another one" 's/ \&\& !read_word_i\[0\]//'
mutant "reads beside the counters keep a word" 's/read_i \&\& read_hit_o/read_i/'

proof  control_registers \
       "pipegs_control_registers+ pipegs_control_bus pipegs_control_shadow pipegs_control_slot
  pipegs_control_counters pipegs_control_events" \
       "@units=1 %PerfW=33"
mutant "a start with an abort is an error" 's/(start_full_i\(control.start) \&\& !control.abort_all/\1/'
mutant "a write to a queued frame is not refused" 's/(!shadow_write_hit) \|\| queued/\1/'
mutant "a start while a frame is queued is no error" \
       's/(start_full_i\(control.start) .* queued/\1 \&\& control.abort_all/'
mutant "the strobes of CONTROL are not looked at" 's/write_data \& write_mask \& \{32/write_data \& {32/'
mutant "an abort does not drop the queue" "s/drop_i\(control.abort_all\)/drop_i(1'b0)/"

proof  control_watch "pipegs_control_watch+" ""
mutant "one cycle too early" "s/left_q == 32'd1/left_q == 32'd2/"
mutant "what moves does not count" 's/waits_i \&\& !moves_i/waits_i/'
mutant "it is told when nothing is owed" 's/waits_i \&\& !moves_i/!moves_i/'
mutant "it is told once" 's/(due   = still) /\1 \&\& !silent_q /'
mutant "no longer silent as soon as it was told" "s/still \&\& \(silent_q \|\| due\)/due/"
proof  control_restart "pipegs_control_restart+" "@default Cycles=4; @default; @default Cycles=13"
mutant "the epoch turns while old reads are out" "s/(StateStop: if \()drained_i/\11'b1/"
mutant "the epoch does not turn" 's/epoch_q <= !epoch_q/epoch_q <= epoch_q/'
mutant "a frame is taken in the cycle of a give-up" 's/(ready_o     = !apart_q) \&\& !give_up_i;/\1;/'
mutant "the core is not in reset before the epoch turns" \
       "/StateApart: begin/,/end/s/core_rst_nq <= 1'b0/core_rst_nq <= 1'b1/"
mutant "the core leaves reset as the epoch turns" \
       "/StateStop: if/,/end/s/(epoch_q <= !epoch_q;)/\1 core_rst_nq <= 1'b1;/"
mutant "the core is in reset as soon as it is apart" \
       "/StateRun: if/,/end/s/(apart_q <= 1'b1;)/\1 core_rst_nq <= 1'b0;/"
mutant "the reset lasts a cycle" "s/StateTurned: if \(left_q == '0\)/StateTurned: if (1'b1)/"
mutant "the core may begin as its reset ends" "s/default: if \(left_q == '0\)/default: if (1'b1)/"
mutant "the tester does not own the reset of the core" 's/test_mode_i \? rst_ni : core_rst_nq/core_rst_nq/'
mutant "a give-up is lost" 's/StateRun: if \(give_up_i\)/StateRun: if (give_up_i \&\& drained_i)/'

# Few writes, then as many as the machine has.
proof  control_done "pipegs_control_done+" "@default %BusWrites=3; @default %BusWrites=1; @default"
mutant "a frame is told before its writes are answered" "s/(done_o *= .*) \&\& left_q == '0/\1/"
mutant "a frame that was given up is told" 's/(done_o *= .*) \&\& !give_up_i/\1/'
mutant "those that wait survive a give-up" "s/(end else if \()give_up_i/\11'b0/"
mutant "an answer in the cycle of the end is waited for" "s/(later_left = writes_i) - WritesW.\(answered_i\)/\1/"
mutant "those behind the oldest frame are forgotten" 's/(later_q *<= )later;/\1later_q;/'
mutant "those behind it wait for its writes alone" 's/( left_q *<= )later_left;/\1left_q;/'
mutant "a frame is told twice" "s/(frames_q *<= frames_q) - FramesW.\(done_o\)/\1/"

# --- rtl --------------------------------------------------------------------------------------------------------------
proof  scheduler "pipegs_scheduler+" "@late=1,order=2 %WindowW=3 %PerfW=8; @default %WindowW=3; @units=1 %WindowW=4"
mutant "the frame ends before all RUs have completed it" 's/complete == .1/complete != 0/'
mutant "the windows of a row are one too few" 's/(windows_i.first_x\)) \+ 1.b1/\1/'
mutant "a frame ends while pixels are on their way" 's/ \&\& !storing_i;/;/'
mutant "the next frame goes to a back that works" 's/(back_take_o *= ahead_q) \&\& !back_q/\1/'
mutant "a frame is taken before the one in the front has gone to the back" \
       's/!front_q \&\& !ahead_q \&\& /!front_q \&\& /'
mutant "splats of the next frame are let in" "s/(hold_o *= )enter_q == '0/\11'b0/"
mutant "the RUs are heard while they finish the frame before" 's/(listen_o *= )!ahead_q \&\& /\1/'

# Of a window with parts that may be walked alone, and of smaller ones.
proof  open "pipegs_open+ ru_own" "@late=1,order=2,window=32,occlusion=1;
       @late=1,order=2,window=128,quads=1,occlusion=1; @late=1,order=2,window=32,units=2,occlusion=1;
       @late=1,order=2,window=128,quads=1,pixel_w=32,occlusion=1,eyes=2,units=2"
mutant "an eye's rows are those of the first one" 's/eye_rows\[p\/Squares\*SideX/eye_rows[0*SideX/' \
       "@late=1,order=2,window=128,quads=1,pixel_w=32,occlusion=1,eyes=2,units=2"
mutant "one region short on the left" "s/from_low\(x\)\}/ClosedW'(from_low(x) + (x != 0))}/"
mutant "one region short on the right" "s/from_high\(x, side\),/ClosedW'(from_high(x, side) + (x != 0)),/"
mutant "one region short above" "s/from_low\(y\),/ClosedW'(from_low(y) + (y != 0)),/"
mutant "one region short below" "s/\{from_high\(y, side\),/{ClosedW'(from_high(y, side) + (y != 0)),/"
mutant "an RU closes regions that are not its own" 's/ \& \{Parts\{own\}\}//'
mutant "RUs in two windows are heard together" "s/here == '1/1'b1/"
mutant "what the RUs closed of the window before" 's/(window_x = progress_i.x\[)0\]/\1Units-1]/; s/here == .1/1/'
proof  layer_free "pipegs_layer_free+" "@default; @units=2; @units=1"
mutant "frees when one RU has finished" "s/some == '1/some != 0/"
mutant "a layer that is finished while one is freed is forgotten" \
       "s/CountW'\(done_i\[i\]\) - /(free_o ? 0 : CountW'(done_i[i])) - /"

# --- rtl/pu -----------------------------------------------------------------------------------------------------------
# The stages' clockwork, with all depths and claims of the machine.
proof  pu_phases "pu_phases+" "machine"
mutant "the output is claimed while a record waits in it" 's/assign out_free    = .*/assign out_free    = 1;/'
mutant "a record is taken before the last phase is over" 's/phase_q == LastPhase \&\& step_o/phase_q >= LastPhase - 1/'

# The same in four cycles, where younger records may be in their phases while one waits to claim.
proof  pu_phases_four "pu_phases+" "Phases=4 Depth=6 Claim=6; Phases=4 Depth=5 Claim=5; Phases=4 Depth=3 Claim=3;
       Phases=4 Depth=2 Claim=2; Phases=4 Depth=11 Claim=14"
mutant "nothing stands still while a record waits to claim" 's/(assign step_o *= ).*/\11;/'
mutant "the last phase but one claims" \
       "s/(Claim-Phases\)\*SlotW\+:SlotW\] == \{1'b1, LastPhase)/\1 - 1'b1/"

# The clockwork of pu_conic and pu_coeff.
proof  pu_turns "pu_turns+" "machine"
mutant "the output is written over" 's/assign advance_o   = .*/assign advance_o   = 1;/'
mutant "a record is taken that came behind the begin of the turn" \
       's/(in_ready_o  = move_o) \&\& fresh_q/\1 \&\& in_valid_i/'
mutant "a Gaussian's turn ends with phase Out" 's/ \&\& !\(fresh_q \&\& in_data_i\)//'

# Small rings, then those of the machine.
proof  pu_payload "pu_payload+" "DataW=2 Places=2; DataW=2 Places=3; DataW=2 Places=1"
mutant "who leaves shows the youngest" 's/words_q\[head_q\]/words_q[tail_q]/' "DataW=2 Places=3"
mutant "the tail stays when one leaves" 's/(if \(walk_i)\) tail_q/\1 \&\& !leave_i) tail_q/'
proof  pu_payload_machine "pu_payload+" "machine DataW=2"
mutant "writes where the next is read" 's/words_q\[tail_q\]/words_q[head_q]/'

proof  sleep "pipegs_sleep+" "Patience=7; Patience=127; Patience=5"
mutant "sleeps while something comes" 's/ \&\& !wake_i//'
mutant "a beat that moves does not keep it awake" 's/moved_i \|\| wake_i\) quiet_q/wake_i) quiet_q/'
mutant "the counter goes on behind its end" "s/else if \(quiet_q != CountW'\(Patience\)\)/else/" "Patience=5"

# Slots, addresses and areas of three layers in a small store, in which a layer is often too big; of two in one of 64.
proof  pu_allocate "pu_allocate+ pu_done pipegs_window_walk ru_own" \
       "@alpha_layers=3 %AlphaLines=16 %AlphaAddresses=32 %Regions=16 %RegionW=4 %MaskW=16 %PartRegionsX=4;
  @alpha_layers=2,units=1,window=32,alpha_lines=64"
mutant "lines are given before slots are free" 's/(decided     = state_q == StateDecide) \&\& room/\1/'
mutant "a layer too many begins" \
       's/(tiles_ready_o = state_q == StateTake) \&\& .*;/\1;/'
mutant "addresses given in the cycle in which a layer is freed are not counted" \
       "s/held_q \+ \(local_lines \?/held_q + (local_lines \&\& !layer_free_i ?/"
mutant "the area stays when the layer ends" 's/area_q \^ own_spilled_q/area_q/'

# Lines of one piece and of two.
proof  pu_spill "pu_spill+" "@default %MemoryW=4 %LineW=4 %AddressW=8 %AlphaAddressW=6 %RegionW=2 %AlphasBits=35;
       @default %MemoryW=4 %LineW=8 %AlphaMemoryLines=2 %AddressW=8 %AlphaAddressW=6 %RegionW=2 %AlphasBits=35;
       @default %AddressW=9 %AlphaAddressW=7 %RegionW=2 %AlphasBits=36"
mutant "an end passes a line that waits" 's/(rows_end_valid_o = .*) \&\& free/\1/'
mutant "a line is taken over one that waits" 's/!ext \|\| free/1/'
mutant "the line behind the area's last one is written" "s/\(SumW'\(number\) \+ SumW'\(1\)\)/SumW'(number)/"
mutant "behind a line that has no room others are written" 's/mem_valid_o   = !free \&\& !full_q/mem_valid_o = !free/'
mutant "both areas are one" "s/!pipegs_pkg::HasLists \&\& alphas_i/1'b0 \&\& alphas_i/"
mutant "a piece goes on before it is taken" 's/next = mem_valid_o \&\& mem_ready_i/next = mem_valid_o/'

proof  pu_join "pu_join+" "@default; @alpha_layers=2"
mutant "an end passes before the lines are written" "s/!is_end \|\| ends_q != '0/1/"
mutant "a splat is counted as an end" 's/is_end \&\& splat_valid_o/splat_valid_o/'

# --- rtl/su -----------------------------------------------------------------------------------------------------------
# Areas of a few lines, then of some hundred.
proof  su_port "su_port+ free_sram_fifo" "@default %MemoryW=8 %SplatBits=8 %AddressW=7 %SlotW=3;
       @default %MemoryW=8 %SplatBits=8 %AddressW=10 %SlotW=5"
mutant "asks for lines without room" \
       's/Answers = pipegs_pkg::SuAnswers/Answers = 2/; s/read_valid_i \&\& room/read_valid_i/'
mutant "a line is forgotten when it is answered" 's/if \(used \&\& !asked\)/if (rsp_valid_i \&\& !asked)/'
mutant "the line behind an area's last one is asked for" \
       's/\(line_q\) >= pipegs_pkg::area_lines/(line_q) > pipegs_pkg::area_lines/'
mutant "runs lie over the records" 's/run_area_i \? pipegs_pkg::AreaRuns/run_area_i ? pipegs_pkg::AreaRecords/'
mutant "merged runs lie over the keys" 's/(run_area_i \? pipegs_pkg::AreaRuns : pipegs_pkg::)AreaMerged/\1AreaKeys/'
mutant "the choice moves before it is taken" 's/if \(choice_q == None\) choice_q/if (!taken) choice_q/'

# Narrow keys through the real pipeline and iterations, and the cells at the widths of the machine. RecordW holds a mark
# too.
proof  su_bitonic "su_bitonic+" "@default %KeyW=1 %RecordW=2; @default %KeyW=2 %RecordW=11"
mutant "one stage too many for a full batch" 's/(1\) << size_q\)) >= fill_q/\1 > fill_q/'
mutant "a key is loaded into a channel that was not sent" 's/fill_q < sent_q\)/fill_q <= sent_q)/'
mutant "a channel without a key is not void" 's/\(i\) >= fill_q/(i) > fill_q/'
mutant "a key is lost in an exchange" 's/(exchanged.* = swap \? b : )a/\1b/'
mutant "the direction of the bit below" \
       's/down_bit = size_q\[DistanceW-1:0\] - distance_q - 1.b1/down_bit = size_q[DistanceW-1:0] - distance_q/'
proof  su_bitonic_cell "su_bitonic+su_bitonic_cell" "@default"
mutant "the lowest bit of the key is not compared" 's/([ab]\[ItemW-1:pipegs_pkg::RecordW)\]/\1+1]/g'
mutant "a bit of the slot stays behind" 's/(exchanged.* = swap \? )b : a/\1{b[ItemW-1:1], a[0]} : a/'
mutant "direction of the last merge" 's/ \&\& !size_q\[DistanceW\]//'

# --- rtl/ru -----------------------------------------------------------------------------------------------------------
proof  ru_walk "ru_walk+ ru_own pipegs_first_set ru_count" "@default EndsMax=48"
mutant "an end that waits for its output is counted again" 's/(window_end = )emit/\1splat_valid_q/'
mutant "an end that comes while one is done is lost" 's/if \(window_done_i \&\& !window_end\)/if (window_done_i)/'

# Small queues, lines from memory in one part and in two; then those of the machine.
proof  ru_fetch \
       "ru_fetch+ pipegs_fifo+ free_sram_fifo" "@default %LineW=4 %MemoryW=4 %FetchLines=4 %RuRecords=12 %AddressW=7;
       @default %LineW=7 %MemoryW=4 %AlphaMemoryLines=2 %FetchLines=4 %RuRecords=12 %AddressW=7;
  @default %LineW=4 %MemoryW=4 %AddressW=9"
mutant "asks the memory without room" "s/ \&\& external_q != FetchW'\(FetchLines\)//"
mutant "asks the store without room" "s/ \+ LocalW'\(asked_q\[1\]\) </ </"
mutant "a line is forgotten when it comes" 's/if \(pop \&\& head_ext \&\& !/if (external_push \&\& !/'

# --- rtl/list ---------------------------------------------------------------------------------------------------------
proof  list_write "pipegs_list_write+ pipegs_list_room pipegs_arbiter pipegs_round_robin pipegs_first_set" \
       "@order=1,units=2 %ListEntryW=4 %ListGap=5 %SplatBits=6 %WindowW=2 %ListWindowW=4 %AddressW=34"
mutant "the count of the record before is not yet in the memory" "s/same_q   *<= move \&\& /same_q <= 0 \&\& /"
mutant "one count is not cleared" "s/left_q <= windows/left_q <= windows - LeftW'(1)/"
mutant "a waiting line is overwritten" 's/\(!out_valid_q \|\| mem_ready_i\)/1/'
mutant "a list runs into the next one" "s/ \|\| entry >> log_o != '0//"
mutant "the first line of a list that has no room is written" "s/none \|\| entry/entry/"

proof  list_read "pipegs_list_read+ pipegs_arbiter+ pipegs_round_robin pipegs_first_set free_line_reader pipegs_sleep" \
       "@order=1,units=2 %WindowW=2 %ListWindowW=4; @order=1"
mutant "a record goes to all" "s/give \? \(item_read \? target : '1\)/give ? ('1)/"
mutant "an SU that has not taken the record loses it" "s/assign free       = .*/assign free = 1;/"
mutant "one window too many" "s/left_q   <= windows - LeftW'\(1\)/left_q <= windows/"

# A Gaussian's eyes, and where walks may be of one alone.
proof  pu_eyes "pu_eyes+" "@late=1,order=2,window=64,quads=1,pixel_w=32,eyes=2;
       @late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2"
mutant "a Gaussian is taken when the first eye has seen it" "s/second_q \|\| wanted != 2'b11/1'b1/"
mutant "an end is shown to both" 's/(last            = )!data \|\| /\1/'
mutant "the right eye alone is shown as the left one" "s/ \|\| wanted == 2'b10\);/);/"
mutant "a walk of one eye shows both" 's/one \? \{eye, !eye\} : wanted_i/wanted_i/' \
       "@late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2"

# --- rtl/dopu ---------------------------------------------------------------------------------------------------------
# Two sets of planes take turns, on the machine that walks windows and the one that walks the whole frame.
proof  dopu_planes "dopu_planes+ pipegs_bit_length" "@default"
mutant "a window is taken while one is inside" 's/window_ready_o = !busy_q/window_ready_o = 1/'
proof  dopu_windows "dopu_windows+ free_planes pipegs_window_walk pipegs_closed" \
       "@late=1,order=2,window=128,quads=1 %Regions=8 %RegionW=3 %MaskW=2 %PlaneBits=1 %WindowW=3 %PlaceW=9;
  @order=1 %Regions=8 %RegionW=3; @default %Regions=8 %RegionW=3;
  @late=1,order=2,window=128,quads=1,occlusion=1 %Regions=8 %RegionW=3 %MaskW=2 %PlaneBits=1 %WindowW=3 %PlaceW=9
  %ClosedW=1 %ClosedBits=4 %OpenBits=27;
  @late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2,occlusion=1 %Regions=16 %RegionW=4 %MaskW=2 %PlaneBits=1
  %WindowW=3 %PlaceW=11 %ClosedW=1 %ClosedBits=4 %EyeClosedW=1 %EyeClosedBits=4 %OpenBits=51"
mutant "a set is overwritten before it is released" 's/planes_ready = !valid_q\[fill_q\]/planes_ready = 1/'
mutant "a release clears the set filled next instead of the oldest" 's/valid_q\[oldest_q\] <= /valid_q[fill_q] <= /'
mutant "a set is called done for the window that it held before" \
       's/(set_done_o += \(done_q \| given_q\)) \& valid_q/\1/'
mutant "a part of a window is left out" "s/2'd2 : part_q/2'd3 : part_q/"
mutant "a window ends with its first eye" 's/ \&\& \(!eyes_q \|\| eye_q == last_eye\)//' \
       "@late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2,occlusion=1 %Regions=16 %RegionW=4 %MaskW=2 %PlaneBits=1
  %WindowW=3 %PlaceW=11 %ClosedW=1 %ClosedBits=4 %EyeClosedW=1 %EyeClosedBits=4 %OpenBits=51"
mutant "the second eye begins with the part behind the first eye's last one" \
       's/next \|\| eye_turns/next/' \
       "@late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2,occlusion=1 %Regions=16 %RegionW=4 %MaskW=2 %PlaneBits=1
  %WindowW=3 %PlaceW=11 %ClosedW=1 %ClosedBits=4 %EyeClosedW=1 %EyeClosedBits=4 %OpenBits=51"
mutant "a walk is done when the regions of the other eye are" "s/(\[2\*WindowW\]) != 1'\(p/\1 == 1'(p/" \
       "@late=1,order=2,window=128,quads=1,pixel_w=32,eyes=2,occlusion=1 %Regions=16 %RegionW=4 %MaskW=2 %PlaneBits=1
  %WindowW=3 %PlaceW=11 %ClosedW=1 %ClosedBits=4 %EyeClosedW=1 %EyeClosedBits=4 %OpenBits=51"
mutant "a window stays in parts" 's/\(parts_q && !next\)/parts_q/'
mutant "a set is filled while another one is on trial" 's/ && !judges_q;/;/'
mutant "the open mask of another part" 's/place_q\[refit_pick\]\)/place_q[!refit_pick])/' \
       "@late=1,order=2,window=128,quads=1,occlusion=1 %Regions=8 %RegionW=3 %MaskW=2 %PlaneBits=1 %WindowW=3 %PlaceW=9
  %ClosedW=1 %ClosedBits=4 %OpenBits=27"
mutant "planes made anew go to the other set" 's/assign refit_set = set_q/assign refit_set = !set_q/' \
       "@late=1,order=2,window=128,quads=1,occlusion=1 %Regions=8 %RegionW=3 %MaskW=2 %PlaneBits=1 %WindowW=3 %PlaceW=9
  %ClosedW=1 %ClosedBits=4 %OpenBits=27"
mutant "a row has one window less" "s/(last_x_i\(raster_i.windows.last_x)\)/\1 - 1'b1)/"

# Places for results are reserved: three levels, a test and readers of which only the promises are known. A node has
# one bit in each field: every bit of it travels by itself.
proof  dopu_descend "dopu_descend+ pipegs_fifo+ free_test free_line_reader" \
       "@default %PlaneBits=1 %MemoryW=1 %WorldW=1 %HalfW=1 %ExpW=1 %ScaleW=1 %SlotW=1 %CountW=1 %NodeBits=11"
mutant "a node enters without a place" \
       "s/Results = pipegs_pkg::DescendResults/Results = 2/; s/ \&\& reserved_q\[l\] != ReservedW'\(Results\)//"
mutant "the place of a node that failed stays reserved" \
       "s/Results = pipegs_pkg::DescendResults/Results = 2/; s/ - ReservedW'\(missed\[l\]\)//"
mutant "a chunk that is shown is taken back when its window is done" 's/ \&\& !shown_q;/;/'
mutant "a chunk counts as shown when it is taken" 's/(shown_q <= chunk_valid_o \&\& )!/\1/'
mutant "an end is dropped with its window" 's/(chunk_done    = )chunk_kind_o == pipegs_pkg::KindData \&\& /\1/'
proof  dopu_lod "dopu_lod+" "@late=1,order=2,lod=1; @late=1,order=2,lod=1,bucket_bits=7,group=64,chunk=64"
mutant "the group's own chunks are opened, too" 's/(coarse \? \{.*), first \+ SlotW.\(count\)/\1, first/'
mutant "the last chunk of proxies is not opened" 's/\(count \+ CountW.\(2 \*\* Shift - 1\)\)/count/'
mutant "a group that has no proxies takes them" "s/ \|\| error == '1;/;/"
mutant "proxies stand near and not far" 's/>= \$unsigned\(least\)/<= $unsigned(least)/'
proof  dopu_open "dopu_open+ free_line_reader" "@late=1,order=2 %SlotW=6 %ChildrenW=4 Most=4 Lines=4;
       @late=1,order=2 %BucketW=4 Most=16 Lines=64"
mutant "one bucket too many is opened" 's/!open_q\[Most-1\]/1/'
mutant "a bucket opened while one is settled is lost" 's/\(take \? open_q : fewer\)/fewer/'
mutant "the nearest bucket stays when it is settled" 's/settled_i \? goes : stays/stays/'
proof  dopu_bucket "dopu_bucket+ pipegs_slot_pool pipegs_first_set free_sram free_sram_fifo" \
       "@late=1,order=2 %BucketW=5 Lists=2 DataW=2 Nodes=4"
mutant "another place than the node's comes back" 's/free_slot_i\(place_q\)/free_slot_i(free_place)/'
mutant "a full queue takes another node" 's/ \&\& !full_o//'
mutant "a chain's head is read while one is written" 's/(read_i\()take_pop \|\| take_insert\)/\1pop_valid_i)/'
