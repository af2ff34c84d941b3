# The table of proofs, read by synth/prove.sh. The comment above each proof says what its parameters mean.
#
# proof  NAME TOP MODULES PARAMETERS [STEPS]  MODULES: `a+b` is module a with the checker b.svh at its end;
#   PARAMETERS: sets of Name=value, with @settings where a package is read (@default: the
#   machine as it is) and %Name=value for a constant changed in it, or `machine`; STEPS of the induction
# mutant NAME MODULE CHANGE PARAMETERS STEPS WHAT          CHANGE: of sed -E; a trace of at most STEPS cycles refutes it

# Every bit of a word travels by itself, so a few bits stand for all widths.
proof  skid skid "skid+skid_proof" "DataW=1; DataW=8; DataW=64"
mutant skid skid 's/if \(in_ready_o\) spare_q/spare_q/' "DataW=1" 8 "the spare register is overwritten"
mutant skid skid 's/(spare_valid_q <= )!out_free \&\& /\1/' "DataW=1" 8 "the spare register is never emptied"
mutant skid skid 's/spare_valid_q \? spare_q : in_i/in_i/' "DataW=1" 8 "the spare beat is lost"

# Small rings of every kind: one word, powers of two, others.
proof  fifo fifo "fifo+fifo_proof" "DataW=2 Depth=1; DataW=2 Depth=2; DataW=2 Depth=3; DataW=2 Depth=5; DataW=2 Depth=8; DataW=2 Depth=13"
mutant fifo fifo 's/in_valid_i \&\& in_ready_o/in_valid_i/' "DataW=1 Depth=2" 8 "accepts a word when full"
mutant fifo fifo 's/out_valid_o \&\& out_ready_i/out_ready_i/' "DataW=1 Depth=2" 8 "gives a word when empty"
mutant fifo fifo 's/(if \(pop \&\& !push\) count_q <= count_q) - /\1 + /' "DataW=1 Depth=2" 8 "counts upwards when a word leaves"
mutant fifo fifo 's/tail_q == PtrW.\(Depth - 1\)/tail_q == PtrW'"'"'(Depth - 2)/' "DataW=1 Depth=3" 10 "the tail turns one place early"
proof  fifo_machine fifo "fifo+fifo_proof" machine
mutant fifo_machine fifo 's/words_q\[head_q\]/words_q[tail_q]/' "DataW=570 Depth=2" 8 "shows the word at the tail"

# Memory: a word and a bit of the solver's choice; sizes up to 64 words of 8 bits, and 1024 of one.
proof  sram sram "sram+sram_proof" "DataW=1 Depth=2; DataW=3 Depth=5; DataW=8 Depth=64; DataW=1 Depth=1024"
mutant sram sram 's/if \(read_i\) //' "DataW=2 Depth=2" 6 "the output changes without a read"
mutant sram sram 's/words_q\[raddr_i\]/write_i ? wdata_i : words_q[raddr_i]/' "DataW=2 Depth=2" 6 "a word that is written in the cycle of the read shows"

# Small rings on the real SRAM, then every ring of the machine on free_sram.
proof  sram_fifo sram_fifo "sram_fifo+sram_fifo_proof sram+sram_proof" "DataW=2 Depth=2; DataW=2 Depth=3; DataW=2 Depth=5; DataW=2 Depth=8; DataW=2 Depth=13"
mutant sram_fifo sram_fifo 's/in_valid_i \&\& in_ready_o/in_valid_i/' "DataW=1 Depth=2" 9 "accepts a word when full"
mutant sram_fifo sram_fifo 's/stored_q \+ CountW.\(out_valid_q\)/stored_q/' "DataW=1 Depth=2" 9 "counts without the head"
mutant sram_fifo sram_fifo 's/\(!out_valid_q \|\| out_ready_i\)/1'"'"'b1/' "DataW=1 Depth=2" 9 "fetches over a head that was not taken"
mutant sram_fifo sram_fifo 's/\.waddr_i\(tail_q\)/.waddr_i(head_q)/' "DataW=1 Depth=2" 9 "writes at the head"
proof  sram_fifo_machine sram_fifo "sram_fifo+sram_fifo_proof free_sram" machine
mutant sram_fifo_machine sram_fifo 's/else if \(out_ready_i\)/else/' "DataW=512 Depth=32" 9 "the head is forgotten before it is taken"

proof  arbiter arbiter "arbiter+arbiter_proof" "Ports=1; Ports=2; Ports=3; Ports=4; Ports=5; Ports=6; Ports=7; Ports=8"
mutant arbiter arbiter 's/> last_q/>= last_q/' "Ports=3" 8 "the port granted last comes first"
mutant arbiter arbiter 's/if \(locked_q \&\& request_i\[shown_q\]\)/if (1'"'"'b0)/' "Ports=3" 8 "a shown grant moves"
mutant arbiter arbiter 's/grant_o\[port\] = request_i\[port\]/grant_o = request_i/' "Ports=3" 8 "all are granted"
mutant arbiter arbiter 's/last_q <= port/last_q <= shown_q/' "Ports=3" 8 "the turn goes on from the wrong port"
proof  arbiter_machine arbiter "arbiter+arbiter_proof" machine
mutant arbiter_machine arbiter 's/above != .0/1'"'"'b0/' "Ports=21" 8 "the lowest port always comes first"

# The ports of the default machine, of the one with lists, and of smaller ones.
proof  memory_arbiter memory_arbiter "memory_arbiter+memory_arbiter_proof arbiter+arbiter_proof" "@default %MemoryW=8; @order=1 %MemoryW=8; @units=2 %MemoryW=8; @units=1 %MemoryW=8"
mutant memory_arbiter memory_arbiter 's/\(!out_valid_q \|\| mem_ready_i\)/1'"'"'b1/' "@units=1 %MemoryW=8" 8 "a shown request is overwritten"
mutant memory_arbiter memory_arbiter 's/if \(take\) request_q <= out/request_q <= out/' "@units=1 %MemoryW=8" 8 "the shown request changes"
mutant memory_arbiter memory_arbiter 's/if \(take \&\& grant\[i\]/if (grant[i]/' "@units=1 %MemoryW=8" 8 "the data of a shown write changes"
mutant memory_arbiter memory_arbiter 's/(assign request = ).*/\1valid_i;/' "@units=1 %MemoryW=8" 8 "no class goes first"
mutant memory_arbiter memory_arbiter 's/mem_rsp_tag_i == /(mem_rsp_tag_i | 1) == /' "@units=1 %MemoryW=8" 8 "an answer goes to the port beside it"
mutant memory_arbiter memory_arbiter 's/TagW.\(port\)/TagW'"'"'(port ^ 1)/' "@units=1 %MemoryW=8" 8 "the tag names another port"

# A small store on the real SRAM, then the default machine's store and that of one unit on free_sram.
proof  alpha_store alpha_store "alpha_store+alpha_store_proof arbiter+arbiter_proof sram+sram_proof" "@units=2,alpha_lines=64 %LineW=4 %AlphaLines=8; @units=1,alpha_lines=64 %LineW=4 %AlphaLines=8"
proof  alpha_store_machine alpha_store "alpha_store+alpha_store_proof arbiter+arbiter_proof free_sram" "@default; @units=2; @units=1"
mutant alpha_store alpha_store 's/(answer_valid_q <= )grant/\1read_valid_i/' "@units=2 %LineW=4 %AlphaLines=8" 8 "the answer goes to all who ask"
mutant alpha_store alpha_store 's/read_address\[RingW-1:0\]/address_i[RingW-1:0]/' "@units=2 %LineW=4 %AlphaLines=8" 8 "reads at the address that is written"
mutant alpha_store alpha_store 's/\.advance_i\(1.b1\)/.advance_i(write_i)/' "@units=2 %LineW=4 %AlphaLines=8" 8 "the turn goes on only with a write"

# The double buffer of Fig. 7: small on the real SRAM, then every buffer of the machine on free_sram.
proof  pixel_buffer pixel_buffer "pixel_buffer+pixel_buffer_proof sram+sram_proof" "DataW=2 Words=2; DataW=2 Words=8"
mutant pixel_buffer pixel_buffer 's/if \(half_q\) fresh_0_q/if (!half_q) fresh_0_q/' "DataW=2 Words=2" 8 "the wrong half becomes fresh"
mutant pixel_buffer pixel_buffer 's/(write_i\(blend_write_i) \&\& !half_q/\1/' "DataW=2 Words=2" 8 "both halves are written"
mutant pixel_buffer pixel_buffer 's/(if \(blend_write_i) \&\& half_q\) fresh_1_q/\1) fresh_1_q/' "DataW=2 Words=2" 8 "a write makes the word of the other half valid"
mutant pixel_buffer pixel_buffer 's/resolve_rdata_o = half_q \? rdata_0 : rdata_1/resolve_rdata_o = half_q ? rdata_1 : rdata_0/' "DataW=2 Words=2" 8 "the resolver sees the blender's half"
proof  pixel_buffer_machine pixel_buffer "pixel_buffer+pixel_buffer_proof free_sram" machine
mutant pixel_buffer_machine pixel_buffer 's/half_q <= !half_q/half_q <= half_q/' "DataW=1088 Words=64" 8 "the halves do not change roles"

# Narrow keys through the real pipeline and iterations, and the cells at the widths of the machine. RecordW holds a mark too.
proof  su_bitonic su_bitonic "su_bitonic+su_bitonic_proof" "@default %KeyW=1 %RecordW=2; @default %KeyW=2 %RecordW=11"
mutant su_bitonic su_bitonic 's/(1\) << size_q\)) >= fill_q/\1 > fill_q/' "@default %KeyW=1 %RecordW=2" 12 "one stage too many for a full batch"
mutant su_bitonic su_bitonic 's/fill_q < sent_q\)/fill_q <= sent_q)/' "@default %KeyW=1 %RecordW=2" 12 "a key is loaded into a channel that was not sent"
mutant su_bitonic su_bitonic 's/\(i\) >= fill_q/(i) > fill_q/' "@default %KeyW=1 %RecordW=2" 12 "a channel without a key is not void"
mutant su_bitonic su_bitonic 's/ItemW\] += swap \? b : a/ItemW] = swap ? b : b/' "@default %KeyW=1 %RecordW=2" 12 "a key is lost in an exchange"
mutant su_bitonic su_bitonic 's/down_bit = size_q\[DistanceW-1:0\] - distance_q - 1.b1/down_bit = size_q[DistanceW-1:0] - distance_q/' "@default %KeyW=1 %RecordW=2" 12 "the direction of the bit below"
proof  su_bitonic_cell su_bitonic "su_bitonic+su_bitonic_cell_proof" "@default"
mutant su_bitonic_cell su_bitonic 's/a\[ItemW-1 -: pipegs_pkg::KeyW\+1\]/a[ItemW-1 -: pipegs_pkg::KeyW]/; s/b\[ItemW-1 -: pipegs_pkg::KeyW\+1\]/b[ItemW-1 -: pipegs_pkg::KeyW]/' "@default" 2 "the lowest bit of the key is not compared"
mutant su_bitonic_cell su_bitonic 's/ItemW\] += swap \? b : a/ItemW] = swap ? {b[ItemW-1:1], a[0]} : a/' "@default" 2 "a bit of the slot stays behind"
mutant su_bitonic_cell su_bitonic 's/ \&\& !size_q\[DistanceW\]//' "@default" 2 "direction of the last merge"

# Two sets of planes take turns, on the machine that walks windows and the one that walks the whole frame.
proof  dopu_planes dopu_planes "dopu_planes+dopu_planes_proof" "@default"
mutant dopu_planes dopu_planes 's/window_ready_o = !busy_q/window_ready_o = 1'"'"'b1/' "@default" 4 "a window is taken while one is inside"
proof  dopu_windows dopu_windows "dopu_windows+dopu_windows_proof free_planes" "@default %Regions=8 %RegionW=3; @order=1 %Regions=8 %RegionW=3"
mutant dopu_windows dopu_windows 's/planes_ready = !valid_q\[fill_q\]/planes_ready = 1'"'"'b1/' "@default %Regions=8 %RegionW=3" 12 "a set is overwritten before it is released"
mutant dopu_windows dopu_windows 's/valid_q\[oldest_q\] <= 1.b0/valid_q[fill_q] <= 1'"'"'b0/' "@default %Regions=8 %RegionW=3" 12 "a release clears the set filled next instead of the oldest"
mutant dopu_windows dopu_windows 's/set_done_o = done_q \& valid_q/set_done_o = done_q/' "@default %Regions=8 %RegionW=3" 12 "a set is called done for the window that it held before"
mutant dopu_windows dopu_windows 's/(if \(x_q == frame_i.last_x\) y_q <= y_q) \+ 1.b1/\1/' "@default %Regions=8 %RegionW=3" 12 "the row of windows stays"
