# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# The table of mutation tests, read by verif/mutation/mutate.sh; docs/trust/trust.md says how it is used.
#
# group  NAME TITLE                      those that follow: one test of ctest, mutation_NAME; the title is for readers
# mutant MODULE WHAT CHANGE [TEST]       CHANGE: of sed -E, in exactly one line of the module (a path: of that file of
#        cpp_model/); TEST: the test that fails, in verif/*/CMakeLists.txt; else the module's own, named as the module
#        without the prefix pipegs_. An expression is matched, not its line, and as little of it as tells it from
#        others.

# --- rtl/dopu ---------------------------------------------------------------------------------------------------------
group dopu "DOPU"
mutant dopu_axis "of two equal components the second one is taken" 's/x >= y && x >= z/x > y \&\& x >= z/' \
       dopu
mutant dopu_layer "the walk goes c, c - 1, c + 1 instead of c, c + 1, c - 1" \
       's/(camera_slab) \+ (distance : camera_slab) -/\1 - \2 +/' dopu
mutant dopu_planes "the margin moves an edge inwards" 's/\(far \? margin : -margin\)/(far ? -margin : margin)/'
mutant dopu_test "the phase runs on while the unit sleeps" 's/if \(awake_i\) phase_q/phase_q/' dopu_free
mutant dopu_test "slack for the cut bits halved" 's/( Slack *= .*\(TestW \+ )2/\11/'
mutant dopu_origin "no block exponent where it is needed first" 's/(longest > LengthW.\(ViewW - )2/\11/' \
       dopu_indoor
mutant dopu_emit "the end of an empty layer is sent" 's/ && !had_chunk_q//' dopu
mutant dopu_emit "a chunk waits for a PU's ready" "s/(is_data \|\| chunk_)room(_i != '0)/\1ready\2/" dopu
mutant dopu_emit "a chunk goes to a PU without room" 's/mask_i\(chunk_room_i\)/mask_i(~chunk_room_i)/' dopu
mutant pipegs_dopu "the clock does not come back for an answer of the memory" 's/(memory_i\()rsp_valid_i \|\| /\1/'
mutant dopu_windows "a set of planes is overwritten before it is released" \
       's/planes_ready = !valid_q\[fill_q\]/planes_ready = 1/' dopu
mutant dopu_windows "a window that goes by parts is done with its first part" \
       's/place_q\[s\]\[PlaceW-1\] && //' dopu_nearest_fast
mutant dopu_windows "the part behind the right one is the one below it, seen or not" \
       's/part_q\[0\] \|\| !right_in/part_q[0]/' \
       dopu_nearest_fast
mutant dopu_windows "a part is on trial, too" 's/(on_trial  = judges_i) && !parts_q/\1/' dopu_nearest_fast
mutant dopu_nearest "a window on trial opens groups" 's/!held_back && open_ready/open_ready/' dopu_nearest_fast
mutant pipegs_dopu "the end of a walk that is given up goes to the PUs" \
       's/(given_up    = walk_end) && /\1 \&\& 1'"'"'b0 \&\& /' dopu_nearest_fast
mutant dopu_lod "the near plane's step does not count" "s/ - \\\$signed\(SumW'\(near_step_i\)\)//"
mutant dopu_lod "an error of half the size" 's/<< Coarser/<< (Coarser - 2)/'
mutant dopu_lod "a group at its limit keeps its Gaussians" 's/>= \$unsigned\(least\)/> $unsigned(least)/'
mutant dopu_rank "cells have proxies, too" "s/(ranked_q.level) == 2'd1/\1 != 2'd2/" \
       dopu_nearest_open
mutant dopu_cells "an entry of 128 groups is empty" "s/item\[.*ChildrenW\] != '0/item.count != '0/" dopu_nearest_open
mutant dopu_load "the last group alone counts" "s/sum_q (\+ SumW'\(group)/\1/"
mutant dopu_load "a group ends in its last bucket" "s/(: near0_q\}) \+ 1'b1/\1/"
mutant dopu_load "a word that is just written is read" 's/again_q \? sums_q : //'
mutant dopu_load "what a window held counts for the next one" 's/(else if \()judged_o\) some_q/\11'"'"'b0) some_q/'
mutant dopu_load "the first bucket of a word alone is judged" 's/(load\[)i(\]\) > most)/\10\2/'
mutant dopu_rank "the farthest corner is taken for the nearest" 's/farthest_q <= farthest/farthest_q <= nearest/' \
       dopu_nearest_fast
mutant dopu_test "the near plane's distance is taken off the farthest corner, too" \
       's/corner_q <= corner_a/corner_q <= sum_a/' dopu_test_walks
mutant dopu_planes "a part reaches as far as its window" 's/half \? W/1'"'"'b0 ? W/' dopu_planes_walks
mutant pipegs_dopu "each part ends its window" \
       's/(part_end    = walk_end) && !set_ends/\1 \&\& 1'"'"'b0 \&\& set_ends/' dopu_nearest_fast
mutant dopu_windows "planes made anew go to the other set" 's/assign refit_set = set_q/assign refit_set = !set_q/' \
       dopu_nearest_fast
mutant dopu_windows "planes of a set that is filled are those made anew for the one before" \
       's/planes_ready && !refitting/planes_ready/' dopu_nearest_fast
mutant dopu_planes "what is closed on the right moves the edge outwards" \
       "s/- (\(WindowPixelW'\(closed_high\))/+ \1/" dopu_planes_walks
mutant dopu_planes "one region short above" \
       "s/(vertical \?) closed_q.top :/\1 closed_q.top + 1'b1 :/" dopu_planes_walks
mutant dopu_descend "no place is reserved for a result of the test" \
       's/ && reserved_q\[l\] != ReservedW.\(Results\)//' dopu
mutant pu_fetch "an end carries a slot" 's/\{pipegs_pkg::SlotW\{is_data\}\} & slot/slot/'
mutant pipegs_line_reader "the last line of a chunk is kept when it is half full" 's/\(last \|\| line_end\)/line_end/' \
       pu_fetch
mutant dopu_cells "both cells of a line are its first one" "s/(item_half_q <= )cell_i\[0\]/\11'b0/" dopu
mutant dopu_cells "the last slab but one ends the window" 's/layer_q == LastLayer/layer_q == LastLayer - 1'"'"'b1/' dopu
mutant dopu_cells "an empty entry is shown" "s/(item\[.*ChildrenW\]) != '0/\1 >= '0/" dopu_nearest_small
mutant dopu_cells "the last line of the table is not loaded" \
       's/(TableLines *= .*TableCells) \+ 1/\1 - 1/' dopu_nearest_small
mutant dopu_cells "the last entry of the table is not walked" 's/(SlabCells) - 1\)/\1 - 2)/' dopu_nearest_small
mutant dopu_memory "the first line of an answer is all of it" 's/(answer) && come_q == lines\)/\1)/' dopu
mutant dopu_memory "groups are taken for chunks" "s/group \? 3'b010 : 3'b001/3'b001/" dopu

# --- rtl/dopu, nearest first ------------------------------------------------------------------------------------------
group nearest "DOPU, nearest chunk first (\`order = 2\`)"
mutant dopu_nearest "the watermark forgets the groups that are being opened" \
       "s/unopened = \{first\[1\], open_nearest\[1\]/unopened = {first[1], {BucketW{1'b1}}/"
mutant dopu_rank "the smaller of own and parent's bucket instead of the larger" \
       's/own > parent \?/own < parent ?/' dopu_nearest
mutant dopu_rank "the third test's result is taken for the second's" "s/valid\[1\] \? 2'd1 : 2'd2/2'd1/" dopu_nearest
mutant dopu_send "a watermark is sent although it has not risen" 's/(mark_due *= .*) && risen/\1/' dopu_nearest
mutant dopu_send "what is shown is taken back when its window is done" 's/ && !shown_q;/;/' dopu_nearest
mutant pipegs_line_reader "the last item but one of a job is marked as the last, too" \
       "s/(out_last_o *= )last;/\1last || item_q + 2'd2 == job_count;/" dopu_nearest
mutant dopu_bucket "a word of buckets is given up although another chain is left in it" \
       's/if \(!own_left\) some_q/some_q/'
mutant dopu_bucket "an insert forgets the other chains of its word" "s/some_own_q \? read : '0/'0/"
mutant dopu_bucket "a node inserted in front of a list's first bucket does not become the first" \
       's/(!first_valid_q\[insert_list_i\]) \|\| insert_bucket_i < first_q\[insert_list_i\]/\1/'
mutant dopu_depth "leading bits of the mantissa taken one place too high" \
       's/wide\[i \+: StepBits\]/wide[i+1 +: StepBits]/'
mutant dopu_test "slack of the nearest corner halved" \
       's/( Lost *= .*SumW.\(1\) <<< \()TestW \+ 1(\)\) \+ )/\1TestW\2/' dopu_test_nearest
mutant dopu_hull "the scale is not floored at the least that a field holds" \
       's/smaller < (\$signed\(RatioW.\()1 << LogF/smaller < \10/'
mutant dopu_hull "the box of the ellipsoids counts for nearer nodes too" "s/(Least = RatioW'\()-6/\16/"
mutant dopu/nearest/dopu_depth.hpp "the model's slack for the cut bits left out" \
       's/\(int64_t\{1\} << \(config\.test_w\(\) \+ 1\)\) \+ //' dopu_depth

# --- rtl/pu: projection -----------------------------------------------------------------------------------------------
group projection "PU: projection"
mutant pipegs_recip "one unit in one entry of the table" "s/18'd204596/18'd204597/"
mutant pipegs_recip "the result is cut instead of rounded" 's/ \+ \(\(OutF \+ 1\).\(1\) << \(Cut - 1\)\)//'
mutant pu_phases "a new record is let into an output that was not taken" \
       's/(out_free *= )!out_valid_q \|\| out_ready_i/\11/' pu_shape
mutant pipegs_sqrt "half of the rounding dropped" "s/ExactW'\(1\) << \(DropF - 1\)/ExactW'(0)/"
mutant pu_decode "the largest component stands one place off" "s/axis == 2'd1 \? largest/axis == 2'd2 ? largest/"
mutant pu_decode "a transparent Gaussian may be as large as an opaque one" "s/PlaceW'\(48\)/PlaceW'(0)/"
mutant pu_decode "the last code is a small scale" "s/steps == '1 \|\| //"
mutant pu_decode "an end has scales" 's/ & \{3 \* ScaleW\{data\}\}//'
mutant pu_decode "a stage goes on while the output waits" 's/ & \{Stages\{fetched_ready_i\}\}//'
mutant pu_cull "rounding of the view coordinates: + half becomes - half" \
       's/\+ (\$signed\(\(SumW \+ 1\).\(1\)\)\) >>> 1)/- \1/'
mutant pu_cull "a part reaches as far as its window" "s/walk6\[2\] \? SpanW/1'b0 ? SpanW/" pu_cull_tight
mutant pu_cull "the right part begins where the left one does" "s/\(walk4\[0\]\)/(1'b0)/" pu_cull_tight
mutant pu_cull "what is closed above is taken off on the left" 's/closed4\.left/closed4.top/' pu_cull_occlusion
mutant pu_cull "what is closed on the left is taken off above" 's/closed4\.top/closed4.left/' pu_cull_occlusion
mutant pu_cull_axis "a part's slack is that of its window" "s/part6_i \? EdgeW/1'b0 ? EdgeW/" pu_cull_tight
mutant pu_cull_axis "one region short on the left or above" "s/aside\(closed_near6_q/aside(closed_near6_q + 1'b1/" \
       pu_cull_occlusion
mutant pu_cull_axis "one region short on the right or below" "s/aside\(closed_far6_q/aside(closed_far6_q + 1'b1/" \
       pu_cull_occlusion
mutant pipegs_closed "what is closed of another window" \
       's/ && \{open_i.window_y, open_i.window_x\} == place_i\[2\*WindowW-1:0\]//' pu_cull_occlusion
mutant pipegs_closed "the open mask of another part" \
       "s/(3'd5: first = open_i.part_)1/\10/" pu_cull_occlusion
mutant pipegs_open "one region short on the left" "s/, from_low\(x\)\}/, ClosedW'(from_low(x) + (x != 0))}/" open
mutant pipegs_open "RUs in two windows are heard together" "s/here == '1/1'b1/" open
mutant pipegs_open "an RU closes regions that are not its own" 's/ & \{Parts\{own\}\}//' open
mutant pu_cull_axis "the gap on the low side without what the cut bits of x may hide" \
       "s/ - focal7_q - SideW'\(near_slack7_q\)/ - focal7_q/" pu_cull_tight
mutant pu_reach "the bound of the rounding errors left out" "s/ \+ \(NW-1\)'\(Error\);/;/"
mutant pu_reach "a scale below the largest rounded down" "s/\(\(one - 7'd1\) >> below\) \+ 7'd1/one >> below/"
mutant pu_reach "the guard band clamps on one side only" "s/wide_side \+ bound < 0 \?/1'b0 ?/"
mutant pu_reach "the axis of the smaller gap" 's/(along_x = gap.gap_x )>=/\1</'
mutant pu_reach "what is dropped is offered" 's/ && bit_valid && kept;/ \&\& bit_valid;/'
mutant pu_project "exponent of the depth key + 1" 's/(z_log *= .*ViewW - )2/\11/' pu_shape
mutant pu_orient "one sign of the Hamilton product" 's/p0 - p1 \+ p2 \+ p3/p0 + p1 + p2 + p3/' pu_shape
mutant pu_jacobian "exponent of the gain + 1" 's/(gain_e_q *<= .*\(Cut)\)/\1 + 1)/' pu_shape
mutant pu_factors "a zero takes part in the search for the largest exponent" \
       "s/(some\[1\] = )some1 && [a-z_.]*v0_1_m != '0/\11/"
mutant pu_factors "a zero first component may win over a smaller second one" \
       's/\(!any0 \|\| e\[1\] > top0\)/(e[1] > top0)/'
mutant pu_factors "the first component sets the exponent even when it is zero" 's/any0 = some\[0\]/any0 = 1/'
mutant pu_squares "the shift of |u1|^2 added instead of subtracted" 's/(out_q\.c_e <= .*) - less_q/\1 + less_q/' \
       pu_shape
mutant pu_covariance "the adder takes the distance of two exponents without its sign" \
       's/swap \? y_e - x_e : x_e - y_e/x_e - y_e/' pu_shape

# --- rtl/pu/box -------------------------------------------------------------------------------------------------------
group box "PU: the oriented box (\`tile_test = 2\`)"
mutant pu_axes "the longer axis turns the other way" 's/(b_m\[SlopeW-1\]) == out_q\.swap/\1 != out_q.swap/'
mutant pu_axes "a round covariance has axes" "s/round     = length <= LengthW.\(RoundW\)/round     = length == '0/"
mutant pu_axes "|b| in place of 2|b|" 's/(assign b_apart .*in_q\.b_e\))/\1 + 1/'
mutant pu_axes "the slope may exceed 1" 's/nearest = near > most \? most : near/nearest = near/'
mutant pu_box "the sides do not grow" "s/(growth *= .*) \+ SideW.\(1\)/\1/" pu_shape_box
mutant pu_box "the exponent of an odd root" 's/assign odd     = e\[0\]/assign odd     = 1/' pu_shape_box
mutant pu_box "the box around lies crosswise" 's/if \(swap_q\) out_q\.box_y/if (!swap_q) out_q.box_y/' pu_shape_box
mutant pu_box "a side too long for its field wraps" "s/length = raised\[.*\] != '0 \? '1 : /length = /" pu_shape_box
mutant pu_touch "a step down turns the other way" 's/u_from - tilt_side/u_from + tilt_side/'
mutant pu_touch "the square counts without its tilt" "s/Half \+ \(LimitW.\(half_tilt\).*;/Half;/"
mutant pu_touch "what touches is apart" 's/u_size\) <= /u_size) < /'
mutant pu_intersect "the oriented box from the first region's corner" 's/(Middle = WayW.\()7/\10/' pu_intersect_oriented

# --- rtl/pu: coefficients, regions, rows ------------------------------------------------------------------------------
group rows "PU: coefficients, regions, rows"
mutant pu_root ">= becomes >" 's/rest >= trial\}/rest > trial}/' pu_conic
mutant pu_extent "margin of the box 361 becomes 360" 's/361/360/' pu_conic
mutant pu_conic "sign of an exponent in narrow" 's/gain \+ ([a-z_.]*larger_e \+ scaled_det_e_q)/gain - \1/'
mutant pu_align "shift off by one" 's/product >>> by/product >>> (by + 1)/'
mutant pu_coeff "one bit more dropped from u" \
       's/LeftW.\(product >>> SlopeDrop\)/LeftW'"'"'((product >>> SlopeDrop) \& ~1)/'
mutant pu_edge "the gradient is not rounded up" 's/(gradient_2_q <= .*) \+ GradientW.\(1\)/\1/'
mutant pu_intersect "a Gaussian with a box is dropped when the box is found" \
       's/(drop *= state_q == StateStart) && none_q/\1/'
mutant pu_intersect "the walk goes on while the test waits" 's/(step *= walk_valid_q) && !hold/\1/'
mutant pipegs_exp2 "shift by one" 's/product >> \(RestW - 1\)/product >> RestW/'
mutant pu_clamp "the cut: < becomes <=" 's/(PowerW.\(~power_i\)) < /\1 <= /' pu_rows
mutant pu_code "the half is not added" "s/CodeW'\(halves\[0\]\)/CodeW'(0)/" pu_rows
mutant pu_row_init "dy^2 becomes dy^2 - 1" 's/Dy \* Dy\)/Dy * Dy - 1)/' pu_rows
mutant pu_row_unit "4 curve becomes 2 curve" 's/curve_i\) <<< 2/curve_i) <<< 1/' pu_rows
mutant pu_region "16 D rx becomes 8 D rx" 's/d_rx_q\) <<< 4/d_rx_q) <<< 3/' pu_rows
mutant pu_rows "the Row Units load although they still walk" 's/move && \(!row_valid_q \|\| row_last\)/move/'
mutant pu_allocate "one layer too many is let in" 's/(tiles_ready_o = state_q == StateTake) && .*;/\1;/'
mutant pu_allocate "the pulse that frees a layer is lost while a Gaussian is in work" \
       's/(ended_q <= .* - EndedW.\(layer_free_i)\)/\1 \&\& state_q == StateTake)/'
mutant pu_allocate "the pulse that frees a layer does not wake the clock" \
       's/if \((line_free_i) \|\| layer_free_i \|\| (restart_i)\)/if (\1 || \2)/'
mutant pu_allocate "the pulse that frees a line does not wake the clock" \
       's/if \(line_free_i \|\| (layer_free_i \|\| restart_i)\)/if (\1)/'
mutant pu_allocate "the pulse that frees a layer is lost in the cycle that takes an end" \
       's/(ended_q <= .* - EndedW.\(layer_free_i)\)/\1 \&\& !take_end)/'
mutant pu_allocate "the end is lost in the cycle of that pulse" \
       's/(ended_q <= .* \+ EndedW.\(take_end)\)/\1 \&\& !layer_free_i)/'
mutant pu_allocate "addresses are given again before their layer is free" \
       "s/SumW'\(held_q\) \+ SumW'\(count_q\) <= /SumW'(count_q) <= /"
mutant pu_allocate "a third layer takes an overflow area" "s/areas_q != 2'd2/1'b1/" pu_allocate_small
mutant pu_spill "the line behind the last one of its area is written" \
       "s/\(SumW'\(number\) \+ SumW'\(1\)\)/SumW'(number)/"
mutant pu_spill "two lines of memory count as one" "s/(lines_end = .*) \* SumW'\(Pieces\)/\1/" pu_spill_wide
mutant pu_spill "the last numbers have a place, so that they may wrap" "s/number\[.*\] == '1 \|\|//"
mutant pu_spill "both areas are one" "s/!pipegs_pkg::HasLists && alphas_i/1'b0 \&\& alphas_i/"
mutant pu_spill "the end leaves before the memory took the last line" 's/(rows_end_valid_o = .*) && free/\1/'
mutant pu_spill "the end is taken while a line waits" \
       's/(alphas_ready_o = )free && rows_end_ready_i/\1rows_end_ready_i/'
mutant pu_join "an end passes before its lines are written" "s/!is_end \|\| ends_q != '0/1/"
mutant pu_join "no more than three ends are counted" 's/(CountW *= ).*;/\12;/'
mutant pu_deal "an end passes when one cull has reached it" "s/is_end == '1/is_end != '0/"
mutant pu_deal "a Gaussian waits for a PU's ready" 's/out_room_i & ~waiting_q/out_ready_i \& ~waiting_q/'
mutant pu_deal "an end goes to one PU only" "s/(if \(take_end\) waiting_q <= )'1/\11/"
mutant pu_deal "the turn goes on while nothing is dealt" \
       "s/(else if \()take_data\) last_q/\1room != '0) last_q/"
mutant pu_four_project "the reciprocal before is used" 's/inv_valid \? inv : inv_q/inv_q/' pu_shape_four
mutant pu_four_orient "the entries 12 and 21 with w y for w x" 's/turn_q\[3\] \? x_late_q/turn_q[3] ? y_q/' \
       pu_shape_four
mutant pu_four_orient "|q'|^2 without w^2" "s/ \+ SumW'\(square1_q\)//" pu_shape_four
mutant pu_four_jacobian "a column of the cross product without its second product" \
       's/ \+ product\[3\]//' pu_shape_four
mutant pu_four_jacobian "the halves of a focal length overlap by a bit" 's/(product\[2\] <<< HalfW)/\1 - 1/' \
       pu_shape_four
mutant pu_four_factors "the distance of t_0 is that of t_1" 's/phase\[1\] \? e\[6\]/phase[1] ? e[7]/' pu_shape_four
mutant pu_four_squares "u0 . u1 is twice as large" 's/\(whole - alone_q\) >>> 1/(whole - alone_q)/' pu_shape_four
mutant pu_four_covariance "0.3 is added in place of c0" 's/first\[3\] \? c0_q : Small/Small/' pu_shape_four
mutant pu_four_conic "roots of the set that a younger record has" \
       's/(give_set_i\()ride_12_q/\1ride_8_q/' pu_shape_four
mutant pu_four_extent "the box lies crosswise" 's/(pixels_x = pixels_q\[)swap_i/\1!swap_i/' pu_shape_four
mutant pu_four_coeff "narrow w is narrow m" "s/(phase\[1\]) \? (RightW'\(in_q)/\1 || phase[2] ? \2/" pu_regions_four
mutant pu_four_coeff "u w is added" "s/(c_q <= c_q) - SumBcW/\1 + SumBcW/" pu_regions_four
mutant pipegs_square "products with the sign bit count as positive" 's/sum -= row/sum += row/' pu_shape_four
mutant pu_regions "a Gaussian that dies leaves its payload in the queue" 's/(out_ready_i.)drop \|\| go/\1go/'
mutant pu_payload "whoever leaves shows the first word" "s/head_q == Last \? '0 : head_q \+ 1'b1/head_q/" pu_regions
mutant pu_turns "the output takes what is not inside" 's/(leave_o *= move_o) \&\& inside_q/\1/' pu_conic
mutant pu_step "the gradient grows by half of a step to the right" \
       's/(d_i\) <<< )\(RightW \+ 1\)/\1RightW/' pu_intersect
mutant pu_step "a row of regions begins where the row before did" \
       's/(power_row_q <= )power_next/\1power_row_q/' pu_intersect
mutant pu_alpha "what was clamped is kept for the pixel behind" 's/if \(enable_clamp_i\)/if (enable_exp_i)/' pu_rows
mutant pu_power "without the twist" 's/ \+ twist_q \* x \* Y;/;/' pu_rows_quadratic
mutant pu_power "the first pixels of a row come again" 's/(column_q <= )column_q \+ .*;/\1column_q;/' pu_rows_quadratic
mutant pu_done "what is done in the window above is done" 's/ && progress\.y\[j\] == window_y//' pu_allocate

# --- rtl/pu: colour ---------------------------------------------------------------------------------------------------
group color "PU: colour"
mutant pipegs_rsqrt "rounding: half becomes one" 's/<< \(DropF - 1\)/<< DropF/'
mutant pu_color_sum "a Gaussian without bands takes a line, too" 's/(line_ready_o +=) pop && shaded/\1 pop/' pu_color
mutant pu_color_sum "the last pair of degree 1 is left out" \
       "s/2'd1:( +)last_step = 3'd1/2'd1:\1last_step = 3'd0/" pu_color
mutant pu_color_rotate "w12 for w21" 's/(row_b = [a-z_.]*)w21/\1w12/' pu_color
mutant pu_color_normalise "does not wait for its output register" \
       "s/\(step_q != 3'd2 \|\| !unit_valid_q \|\| unit_ready_i\)/1/" pu_color
mutant pu_color_basis "a result lands in an output that was not taken" \
       's/(go *= )!landing \|\| !basis_valid_q \|\| basis_ready_i/\11/' pu_color
mutant pu_color_fetch "a line behind the table is asked for" 's/number < colors_i/number <= colors_i/' pu_color
mutant pu_color_fetch "a job behind a bad one is taken" 's/ && !bad_q;/;/' pu_color
mutant pu_color_fetch "a job is taken while a request is pending" 's/room && !mem_valid_q/room/' pu_color
mutant pu_color_mantissas "coefficients masked at the wrong degree" \
       "s/degree_i == 2'd1(\) coefs)/degree_i == 2'd2\1/" pu_color
mutant pu_color_codes "band 3 has the exponent of band 2" 's/i < 8 \? 1 : 2/1/' pu_color_coded
mutant pu_color_codes "codes are taken for mantissas" 's/ << shift_pair.of\[i\/3\]//' pu_color_coded
mutant pu_color_codes "the eighths of the lower half only" 's/one \? quarter_i\[2\] : //' pu_color_coded
mutant pu_color "busy: AND for OR" 's/fetch_busy \|\| sum_busy/fetch_busy \&\& sum_busy/'

# --- rtl/su -----------------------------------------------------------------------------------------------------------
group su "SU"
mutant su_bucket "the bucket is read one bit of the depth too low" \
       's/depth_i\[pipegs_pkg::DepthW-1 -:/depth_i[pipegs_pkg::DepthW-2 -:/' su_marks
mutant su_bucket "what is nearer than the first octave goes to the last bucket" "s/beyond\[StepW\] \? '0 : //" \
       su_marks
mutant su_range "the last bucket ends with its own step" 's/last \? \{StepW\{1.b1\}\} : //'
mutant su_release "an end that releases all releases what is nearer only" \
       's/(job_all_i\(spill_job_i) \|\| head_all/\1/' su
mutant su_stores "a link is written in the cycle in which the splitter has the port" \
       's/(link_ready_o = )!split_claim_i/\11'"'"'b1/' su
mutant su_stores "nobody hears that the pool is written" "s/(busy_o = )write_q/\11'b0/" su
mutant su_stores "a number is written where a record that comes in would lie" \
       's/(slot_q +<= )external_i\.write \? external_i\.slot : /\1/' su_tiny
mutant su_stores "the number of a record in memory is not written" \
       's/(payload_q <= .*)external_i\.write \? external_i\.number : /\1/' su_tiny
mutant su_minmax "the largest is compared with the smallest" 's/key_i > max_q/key_i > min_q/' su
mutant su_bitonic "direction of the last merge" 's/ && !size_q\[DistanceW\]//'
mutant su_bitonic "one stage too many for a full batch" 's/(<< size_q\)) >= fill_q/\1 > fill_q/'
mutant su_split "the tail of a bucket is overwritten" 's/\{filled \? tail : drop_slot_q/{drop_slot_q/'
mutant su_output "a splat is shown to the spill too while it goes to the merge" \
       's/(back_valid_o = valid) && divert_i/\1/' su
mutant su_collect "the end of a part turns no set" \
       's/(in_kind_i )!= (pipegs_pkg::Kind)LayerEnd/\1== \2WindowEnd/' su_marks
mutant su_collect "a spill goes on until the end of its walk" \
       's/(Spill: .*take && !data)\)/\1 \&\& mark_all_o)/' su_marks_tiny
mutant su_collect "what stays in memory is followed into the pool" 's/stay_i (\? Spill : Collect)/1'"'"'b0 \1/' \
       su_marks_tiny
mutant su_gather "what returns is taken from the input" 's/returns_i (\? back_i : in)/1'"'"'b0 \1/' su_marks_tiny
mutant su_merge "the end of a part goes to the RUs" 's/!= (pipegs_pkg::Kind)WindowEnd/== \1LayerEnd/' su_merge_marks
mutant su_merge "a comparison is not inverted for the other lane" 's/(beats\[j\*Units\+i\] = )!/\1/'
mutant su_key "index sorted downwards" 's/\{splat_i\.depth, splat_i\.index\}/{splat_i.depth, ~splat_i.index}/' su_merge
mutant su_spill "the lines of keys begin one too far" \
       's/(keys_line_o *= )number_q >> PartW/\1(number_q >> PartW) + 1/' su_tiny
mutant su_spill "a record that comes in takes the place of one that is shown" 's/(in_valid_i) && !back_q/\1/' su
mutant su_spill "the last key of a line is not that of its record" 's/if \(shown\) (keys_o)/if (!shown) \1/' su_tiny
mutant su_spill "the last line of keys is not written" 's/ \|\| \(close && part != .0\)//' su_tiny
mutant su_spill "more than fits the pool returns to it" 's/(rest_i > SlotW.\()(pipegs_pkg::SuRefill)/\14 * \2/' \
       su_marks_tiny
mutant su_spill "the line of keys that was not full is not written again" \
       's/start_i \|\| stay_o \|\| (record_ready_i\) keys)/start_i || \1/' su_marks_tiny
mutant su_runs "a line is read before all of it is in memory" 's/: listed_i;/: listed_i + 1'"'"'b1;/' su_tiny
mutant su_runs "the bucket of the mark leaves, too" 's/bucket < mark_i\.bucket/bucket <= mark_i.bucket/' su_marks_tiny
mutant su_runs "what was sent leaves again" 's/bucket >= from_q/1'"'"'b1/' su_marks_tiny
mutant su_runs "what returns meets what is still sent" 's/if \(idle_i\) (state_q <= Return)/\1/' su_marks_tiny
mutant su_lines "the last line of a run is not written before it is full" 's/ \|\| left_q == SlotW.\(1\)//' su_tiny
mutant su_levels "the area that is read does not change" 's/(area_q *<= )!area_q/\1area_q/' su_tiny
mutant su_ways "a line is asked for without a place" "s/ && held_q\[i\] != HeldW'\(Lines\)//" su_tiny
mutant su_tree "the nearer one stays" 's/(loser\[.*\]) < (rising)/\1 > \2/' su_tiny
mutant su_emit "the end of a set that spilled asks the memory for a record" \
       's/spilled_i && !item_end_i/spilled_i/' su_tiny
mutant su_emit "a record is fetched while the pool is written" 's/(head_ready .*sent\)) && !record_busy_i/\1/' su
mutant su_emit "a number is read while the pool is written" 's/(look .*!looked_q) && !record_busy_i/\1/' su
mutant su_emit "a number that waits for the pool is known" 's/(outside) && \(look \|\| looked_q\)/\1/' su
mutant su_emit "a record that waits for the pool is shown" 's/(valid_q <= head_valid) && head_ready/\1/' su
mutant su_emit "asleep while the pool is written" 's/(!head_valid\)) \|\| record_busy_i/\1/' su
mutant su_port "a line behind its area is asked for" 's/\(line_q\) >= (pipegs_pkg::area_lines)/(line_q) > \1/' su
mutant su_port "goes on behind a line that has no room" 's/(choice_q != None) && !full_o/\1/' su
mutant su_port "asks for lines without room" 's/read_valid_i && room/read_valid_i/' su
mutant su_buckets "the bucket of the mark leaves too" "s/(LowW'\(i\)) < job_low/\1 <= job_low/" su_marks
mutant su_buckets "a word of buckets that was given up comes back" "s/(with_bucket = )held \? word : '0/\1word/" su
mutant su_buckets "a bucket is read while an insertion writes the table" \
       's/(!chain_due) && operation_q != Insert/\1/' su_marks
mutant su_buckets "a bucket waits until no record comes" "s/(entry_turn *= )inserted_q/\11'b0/" su_marks
mutant su_gather "a full pool spills nothing" "s/(\.full_i)\(.*\),/\1(1'b0),/" su_tiny
mutant su_sort "an end overtakes the keys before it" 's/(end_go *= chain_valid_i && is_end) && split_idle_o/\1/' su
mutant su_overflow "a line of keys is shown as a record, too" 's/(line_valid_o = line_shown) && !line_fetch/\1/' su_tiny
mutant su_external "a run is as long when it is merged as its groups were" \
       "s/forms \? (SlotW'\(group_o\.count\)) : merge_keys/\1/" su_tiny

# --- rtl/ru -----------------------------------------------------------------------------------------------------------
group ru "RU"
mutant ru_blend "stop: < becomes <=" 's/remain < TW/remain <= TW/'
mutant ru_blend "the last Gaussian takes its own weight only" 's/(weight = )last_1_q \? t_1_q : /\1/'
mutant ru_blend "a Gaussian that does not reach the pixel takes all" "s/t_i < rest_i && code_i != '0/t_i < rest_i/"
mutant ru_blend "INRIA's rule holds beside a frame's own" "s/ && rest_i == '0 && remain/ \&\& remain/"
mutant ru_blend "half of the rounding dropped" 's/ \+ Half\) >> AlphaW/) >> AlphaW/'
mutant ru_own "every row begins with the same unit" 's/ \+ Step \* \(r \/ RegionsX\)//' ru
mutant ru_slot "shift off by one" 's/\$clog2\(([a-z_:]*Units)\)/($clog2(\1) + 1)/' ru
mutant ru_count "sum becomes OR" 's/\(fields & Low\) \+/(fields \& Low) |/' ru
mutant ru_dispatch "the end of a layer only to the RUs whose regions it covers" \
       's/kind != ([a-z_:]*)KindData( \|\| \(in_i)/kind == \1KindWindowEnd\2/'
mutant ru_walk "done of the window before is used" "s/ends_q == '0 \? (rest_q & ~done_i) : rest_q/\1/" ru
mutant ru_walk "the line of a done region stays in its store" 's/(walked *= ).*;/\1live;/' ru
mutant ru_walk "the line of a done region is read" "s/is_data && \(lowest & live\) == '0/1'b0/" ru
mutant ru_fetch "both areas are one" "s/in_i\.address\[NumberW\] \?/1'b0 ?/"
mutant ru_fetch "a skipped line waits for room" 's/\(skip \|\| (\(record_ready && local_room\))\)/\1/'
mutant ru_fetch "a skipped line is waited for" 's/in_valid_i\(fire && !skip\)/in_valid_i(fire)/'
mutant ru_window "regions below the image: <= becomes <" 's/rows_d <= \(Shift/rows_d < (Shift/' ru
mutant ru_lanes "second row of a quarter inside the image by mistake" \
       "s/rows_i <= top \+ SideW'\(1\) \? 8'hff : columns_out/columns_out/" ru
mutant ru_lanes "a region is done with its last quarter" "s/\(quarter_3_q == 2'd0 \|\| all_q\) && //" ru
mutant ru_resolve "quarters of a region: 3 becomes 2" "s/next_quarter_q == 2'd3/next_quarter_q == 2'd2/" ru
mutant ru_resolve "regions outside the image are written" 's/ & ~outside_i//' ru
mutant ru_memory "a write is accepted in the cycle of a read" 's/free && !read_valid_i/free/' ru
mutant ru_memory "a read asks for half a line" "s/read_valid_i \? '1 : write_halves_i/write_halves_i/" ru
mutant ru_window "raster order: a row of windows is one row of pixels high" "s/(AddressW'\(before_q\)) << Shift/\1/" ru
mutant ru_offset "raster order: a region goes on below the picture" "s/(more_o *= )first.*/\11'b1;/" ru
mutant ru_offset "raster order: all regions lie in the low halves of lines" "s/(half_o *= )column\[0\]/\11'b0/" \
       ru_units1
mutant ru_lines "raster order: the second row of a word lies in the next line" \
       "s/raster_i \? AddressW'\(stride_i\) : //" ru
mutant ru_lines "raster order: the halves of a line are exchanged" 's/\{half_i, !half_i\}/{!half_i, half_i}/' ru
mutant ru_join "a line leaves with one of its rows" 's/in_valid_i && pair_valid_i && !odd_i/in_valid_i \&\& !odd_i/'
mutant ru_join "a half that is not in the picture is written" "s/\{wide_i, 1'b1\}/2'b11/"
mutant ru_join "the row of the even RU is always the left one" 's/in_halves_i\[0\] \? (\{pair_row_i, row\}).*;/\1;/'
mutant ru_join "the odd RU's row stays" 's/odd_i \? pair_taken_i : pair_taken_o/pair_taken_o/'
mutant ru_pixels "raster order: A is 0" "s/(bytes\.of\[4\*i\+3\] = )'1/\1'0/" ru
mutant ru_byte "the second third of the codes begins one late" "s/10'd343/10'd344/"
mutant ru_unorm "a half is rounded down" "s/(WideW'\(1\) << \(Fraction - 1\))/(\1) - 1'b1/" ru_unorm_byte_16
mutant ru_whole "buffers swap at a layer's end" 's/swap_i\(window_done_o\)/swap_i(layer_done_o)/' ru
mutant ru_source "asleep while lines are fetched" 's/walk_idle && fetch_idle/walk_idle/' ru

# --- rtl/ru/live ------------------------------------------------------------------------------------------------------
group quads "RU that blends living quads (\`quads = 1\`)"
mutant ru_regions "a splat leaves although its last region finds no room" \
       "s/last && \(move \|\| open == '0\)/last/"
mutant ru_regions "regions are picked in a cycle in which it is not known which are open" \
       "s/(free != '0 && move) && !hold_i/\1/"
mutant ru_regions "a region is picked before it was handed over" 's/(free += open) & ~part_held/\1/'
mutant ru_regions "E ry rx for E ry ry" 's/(e_ry_2_q\) \* SquareW.\()ry/\1rx/'
mutant ru_power "of each row a group has the same column" 's/(Column = )\(g \+ 2 \* j\) % 4/\1g/'
mutant ru_power "a half leaves when one of its groups has room" \
       "s/\(some & ~out_room_i\) == '0/(some \& out_room_i) != '0/"
mutant ru_power "quads that have stopped live" 's/ && !stopped\[i\]//'
mutant ru_power "the exponents of dead quads are stored, those of living ones stand still" \
       's/pixels_move && live\[i\]/pixels_move \&\& !live[i]/'
mutant ru_quads "a quad comes again after three cycles" "s/\(valid_3_q && address_3_q == address\)/1'b0/" ru_live_parts
mutant ru_quads "outside the image: every row of quads has the column of the first" "s/ \^ \{row_2_q\[0\], 1'b0\}//" \
       ru_live_parts
mutant ru_quads "a window begins without what lies outside" "s/(stopped_q <= )outside_i/\1'0/" ru_live_parts
mutant ru_quads "a job leaves the word as it was" 's/drain_5_q \? Clear : blended/blended/' ru_live_parts
mutant ru_quads "a quad starts in the turn of a job" 's/(half_valid && !conflict) && !drain_i/\1/' ru_live_parts
mutant ru_drain "a word is asked for that finds no place" 's/\(quiet_q \|\| room\)/1/'
mutant ru_drain "a region is handed over one row too early" "s/row_q == 2'd3/row_q == 2'd2/"
mutant ru_drain "slots outside the image are handed over" "s/held_q <= ~outside_i/held_q <= '1/"
mutant ru_live "raster order: a window ends without that of the other RU" \
       's/ && \(!joined_i \|\| pair_at_end_i\)//'
mutant ru_drain "raster order: words below the picture are written" 's/ && shown\}/}/'
mutant ru_drain "raster order: every word is two requests" 's/ \|\| !place_two\)/)/'
mutant ru_drain "no slot goes first" "s/first != '0 \? first : left/left/"
mutant ru_live "a layer's end hands the regions over" 's/start_i\(window_done_o\)/start_i(layer_done_o)/'
mutant ru_live "rows of quads are read as if all began with the same group" 's/(Odd = \(Even \+ )2/\10/'
mutant ru_live "the banks are shown to the drain a cycle too early" 's/(StoredW\{job_q\[)2/\11/'
mutant ru_live "done of the window before is shown in the next one" 's/ && !clear_q( && slots_stopped)/\1/'

# --- rtl/ru/aovs ------------------------------------------------------------------------------------------------------
group aovs "What an RU writes beside colours (\`aov_coverage\` ...)"
mutant ru_aovs "of equal weights the farthest counts" 's/weight_q > aovs_i/weight_q >= aovs_i/' ru_aovs
mutant ru_aovs "the median is that of the last Gaussian" "s/before_i\[TW-1:TW-2\] != '0 && //" ru_aovs
mutant ru_aovs "the sum of depths wraps" "s/total\[DepthW\] \? '1 : //" ru_aovs
mutant ru_aovs "whatever comes is counted" 's/taken_q && (blended !=)/\1/' ru_aovs
mutant ru_blend "a Gaussian before which the pixel stops has its depth" 's/(some_1_q) && !hold/\1/' ru_aovs
mutant ru_quads "a cleared word keeps its AOVs" 's/drain_5_q \? \{Lanes\{Fresh\}\} : aovs/aovs/' ru_aovs
mutant ru_quads "the index is that of the quad behind" 's/index_5 = index_5_q/index_5 = index_4_q/' ru_aovs
mutant ru_linear "depths are cut" "s/(shifted\)) \+ 1'b1/\1/" ru_regions_aovs
mutant ru_linear "what lies beyond the range is near" 's/exponent > range_i \|\| //' ru_regions_aovs
mutant ru_aov_lines "where no Gaussian is, there is one of 24 bits" "s/best == '1/1'b0/" ru_drain_aovs
mutant ru_aov_lines "the count lies below T" \
       's/\{(kept\[BlendedW-1:0\]), (kept\[KeptW-1 -: 16\])\}/{\2, \1}/' ru_drain_aovs
mutant ru_drain "AOVs are written that nobody wants" "s/wanted_aovs_i & (\(turn_q)/\1/" ru_drain_aovs
mutant ru_drain "AOVs are written over the colours" 's/place \+ ahead/place/' ru_drain_aovs
mutant pipegs_errors "AOVs that have no room are written" \
       "s/ && raster_i.aovs.wanted != '0 && .*;/ \&\& 1'b0;/" errors_aovs

# --- two eyes: in the modules that know of them -----------------------------------------------------------------------
group eyes "Two eyes in one walk (\`eyes\`)"
mutant pu_eyes "the second eye's view is shown of ends, too" 's/(last            = )!data \|\| /\1/' pu_eyes
mutant pu_eyes "the right eye alone is shown as the left one" "s/ \|\| wanted == 2'b10\);/);/" pu_eyes
mutant pu_cull "half the way between the eyes is cut" \
       "s/\(twice \+ \\\$signed\(\(HalfW \+ 1\)'\(1\)\)\) >>> 1/twice >>> 1/" \
       pu_cull_eyes
mutant pu_cull "both eyes stand in one place" 's/eye \? -rounded : rounded/rounded/' pu_cull_eyes
mutant pu_cull "the eyes are as far apart down as they are to the right" \
       's/shift\(half_y_i/shift(half_x_i/' pu_cull_eyes
mutant dopu_test "the left plane stays where one eye has it" 's/(assign lower       = ).*/\1beside;/' dopu_test_eyes
mutant dopu_test "one eye's right plane moves to the other's side" 's/eye != axis_q.negative/eye == axis_q.negative/' \
       dopu_test_eyes
mutant dopu_test "what flooring takes off a reach is lost" "s/ \+ TestW'\(axis_q.reach != '0\)//" dopu_test_eyes
mutant dopu_test "no room for the sum of scale and reach" 's/(eyes_length\) : length\)) \+ 1.b1/\1/' dopu_test_eyes
mutant dopu_load "both eyes may hold as much as one" 's/pair_i \? most >> 1 : most/most/' dopu_load_eyes
mutant dopu_load "only the last word says what is too much for both" 's/(crowded = some) \|\| some_q/\1/' dopu_load_eyes
mutant dopu_windows "a window ends with its first eye" 's/ && \(!eyes_q \|\| eye_q == last_eye\)//' dopu_nearest_eyes
mutant dopu_windows "a walk is done when the other eye's regions are" "s/(\[2\*WindowW\]) != 1'\(p/\1 == 1'(p/" \
       dopu_nearest_eyes
mutant pipegs_dopu "an eye's walk has the planes of both" 's/!pair \|\| set_place\[s.*/!pair;/' dopu_nearest_eyes
mutant pipegs_closed "what is closed of the other eye" "s/(5'b10000: walk = open_i.eye_)0/\11/" dopu_nearest_eyes
mutant pipegs_open "an eye's regions count for the first one" \
       's/eye_rows\[p\/Squares\*SideX/eye_rows[0*SideX/' open_eyes
mutant pu_eyes "a walk of one eye shows both" 's/one \? \{eye, !eye\} : wanted_i/wanted_i/' pu_eyes_walks
mutant dopu_origin "the unit of view space leaves no room for the eyes" "s/(own > eyes \? own : eyes\)) \+ 1'b1/\1/" \
       dopu_nearest_eyes
mutant pu_deal "the other eye's view goes to any PU" 's/paired \? last_q : in_turn/in_turn/' pu_deal_eyes
mutant pu_deal "what the other fronts have comes between" 's/paired \? second : data/data/' pu_deal_eyes
mutant pu_color_fetch "a line is kept over an end" 's/(else if \(take\) asked_q <= )ask/\1asked_q || ask/' pu_color_eyes
mutant pu_color_fetch "every job has the line of the one before" 's/ && address == mem_address_q//' pu_color_eyes
mutant pu_color_sum "the line of the job before is not kept" 's/again \? kept_q : line_i/line_i/' pu_color_eyes
mutant pu_parts "both eyes draw the left picture" "s/(PartW-1\] = )payload.eye/\11'b0/" pu_parts_eyes
mutant ru_drain "the right picture lies over the left one" 's/line_i \+ eye_lines_i/line_i/' ru_drain_eyes
mutant ru_live "an eye that nobody wants is drawn" 's/unseen_i\[/1'"'"'b0 \& unseen_i[/' ru_eyes_small

# --- rtl/buf ----------------------------------------------------------------------------------------------------------
group buf "Buffers"
mutant pipegs_first_line "the highest one's line" 's/i = Ports; i > 0; i -= 1/i = 1; i <= Ports; i += 1/'
mutant pipegs_sram_fifo "counts without the head" "s/stored_q \+ CountW'\(out_valid_q\)/stored_q/"
mutant pipegs_sram_fifo "accepts a word when full" 's/(push *= in_valid_i) && in_ready_o/\1/'
mutant pipegs_memory_arbiter "a shown request is overwritten before the memory took it" \
       's/\(!out_valid_q \|\| mem_ready_i\)/1/'
mutant pipegs_memory_arbiter "requests are taken though it is stopped" 's/ && !stop_i//'
mutant pipegs_memory_arbiter "the data of a shown write changes" \
       's/if \(take && out\.write\) data_q/if (out.write) data_q/'
mutant pipegs_memory_arbiter "a write changes what another port's write would" \
       's/ \| \{pipegs_pkg::HalvesW\{!grant_q\[i\]\}\}//'
mutant pipegs_memory_arbiter "bursts of geometry follow each other at once" "s/(able +=) .*/\1 '1;/"
mutant pipegs_memory_arbiter "geometry goes before the colours" 's/(second +=) .*/\1 others;/'
mutant pipegs_memory_arbiter "an answer goes to two ports: the lowest bit of the tag is ignored" \
       's/(mem_rsp_tag_i) == ([a-z_:]*TagW.\(i\))/\1 >> 1 == \2 >> 1/'
mutant pipegs_round_robin "after the last one nobody has a turn" \
       "s/behind != '0 \? first_behind : first/first_behind/" pu_deal
mutant pipegs_round_robin "always the first one's turn" "s/behind != '0 \? first_behind : first/first/" dopu

# --- rtl/control ------------------------------------------------------------------------------------------------------
group control "Control: registers"
mutant pipegs_control_bus "an answer that was not taken is overwritten" \
       's/(read_o *= !ar_ready_q) && \(!r_valid_q \|\| s_axi_i.r_ready\)/\1/' control_registers
mutant pipegs_control_bus "the answer to a write is never an error" \
       "s/(b_error_q <= )write_error_i/\11'b0/" control_registers
mutant pipegs_control_bus "the strobe of the second byte is that of the first" \
       's/\{8\{w_strobe_q\[1\]\}\}/{8{w_strobe_q[0]}}/' \
       control_registers
mutant pipegs_control_slot "a signed value reads without its sign" \
       's/64\{Signed && /64{!Signed \&\& /' control_registers
mutant pipegs_control_slot "addresses are kept in bytes" 's/next\[Shift \+: Width\]/next[0 +: Width]/' control_registers
mutant pipegs_control_slot "a write of the low word reaches the high one" \
       "s/(\{write_mask_i, )32'd0\}/\1write_mask_i}/" \
       control_registers
mutant pipegs_control_shadow "a queued frame can be written" 's/(write *= write_i) && !queued_q/\1/' control_registers
mutant pipegs_control_shadow "an abort does not drop what is queued" \
       's/else if \(drop_i\)/else if (drop_i \&\& !queued_q)/' \
       control_registers
mutant pipegs_control_shadow "a value that does not exist is outside the table" \
       's/(read_hits\[i\] *= )/\1Width != 0 \&\& /' control_registers
mutant pipegs_control_events "a later error replaces the first address" \
       "s/(error_i != '0) && kept == '0/\1/" control_registers
mutant pipegs_control_events "an address that is not known is shown" 's/ & \{AddressW\{located_i\[i-1\]\}\}//' \
       control_registers
mutant pipegs_control_events "a clear wins over an event" \
       's/(error_next *= )\(error_q & (~clear_error_i\[Causes:0\])\)( \| .*);/\1(error_q\3) \& \2;/' control_registers
mutant pipegs_control_events "frames started are counted when they are queued" \
       "s/32'\(taken_i\)/32'(freed_i)/" control_registers
mutant pipegs_control_counters "the high word is that of now" \
       "s/32'\(high_q\)/32'(count[PerfW-1:32])/" control_registers
mutant pipegs_control_counters "the read of a high word keeps another one" 's/ && !read_word_i\[0\]//' control_registers
mutant pipegs_control_counters "the last counter's place is outside" \
       's/read_word_i < End/read_word_i < End - 2/' control_registers
mutant pipegs_control_registers "a write to what can only be read is not refused" \
       "s/(write_error *= )!live_writable/\1!(live_writable || write_word < 16)/"
mutant pipegs_control_registers "a start with an abort is an error" \
       's/(start_full_i\(control.start) && !control.abort_all/\1/'
mutant pipegs_control_registers "the enables are written without strobes" \
       's/irq_enable_q\[2:0\] & ~write_mask\[2:0\]/3'"'"'d0/'
mutant pipegs_control_registers "the time-out is written without strobes" "s/timeout_q & ~write_mask/32'd0/"
mutant pipegs_control_registers "a reset leaves no time-out" "s/pipegs_pkg::ControlBusTimeoutReset/'0/"
mutant pipegs_control_registers "the abort lasts" 's/(abort_q <= control.abort_all)/\1 || abort_q/'
mutant pipegs_control_watch "one cycle too early" "s/left_q == 32'd1/left_q == 32'd2/"
mutant pipegs_control_watch "what moves does not count" 's/waits_i && !moves_i/waits_i/'
mutant pipegs_control_watch "it is told when nothing is owed" 's/waits_i && !moves_i/!moves_i/'
mutant pipegs_control_watch "it is told once" 's/(due   = still) /\1 \&\& !silent_q /'
mutant pipegs_control_watch "it is silent for a cycle" 's/still && \(silent_q \|\| due\)/due/'
mutant pipegs_control_restart "the epoch turns while old reads are out" "s/(StateStop: if \()drained_i/\11'b1/"
mutant pipegs_control_restart "the epoch does not turn" 's/epoch_q <= !epoch_q/epoch_q <= epoch_q/'
mutant pipegs_control_restart "a frame is taken in the cycle of a give-up" 's/(= !apart_q) && !give_up_i;/\1;/'
mutant pipegs_control_restart "the core is not in reset before the epoch turns" \
       "/StateApart: begin/,/end/s/core_rst_nq <= 1'b0/core_rst_nq <= 1'b1/"
mutant pipegs_control_restart "the core leaves reset as the epoch turns" \
       "/StateStop: if/,/end/s/(epoch_q <= !epoch_q;)/\1 core_rst_nq <= 1'b1;/"
mutant pipegs_control_restart "the core is in reset as soon as it is apart" \
       "/StateRun: if/,/end/s/(apart_q <= 1'b1;)/\1 core_rst_nq <= 1'b0;/"
mutant pipegs_control_restart "the reset lasts a cycle" "s/(StateTurned: if \().*\) begin/\11'b1) begin/"
mutant pipegs_control_restart "the core may begin as its reset ends" "s/(default: if \().*\) begin/\11'b1) begin/"
mutant pipegs_control_restart "in the scan test the flip-flop stays in the way" 's/test_mode_i \? rst_ni : //'
mutant pipegs_control_counters "counters are read while the core is kept apart" \
       's/hits\[i\] && !apart_i/hits[i]/' control_registers
mutant pipegs_control_done "a frame is told before its writes are answered" "s/(done_o *= .*) && left_q == '0/\1/"
mutant pipegs_control_done "a frame that was given up is told" 's/(done_o *= .*) && !give_up_i/\1/'
mutant pipegs_control_done "those that wait survive a give-up" "s/(end else if \()give_up_i/\11'b0/"
mutant pipegs_control_done "an answer in the cycle of the end is waited for" \
       "s/(later_left = writes_i) - WritesW'\(answered_i\)/\1/"
mutant pipegs_control_done "those behind the oldest frame are forgotten" 's/(later_q *<= )later;/\1later_q;/'
mutant pipegs_control_done "those behind it wait for its writes alone" 's/( left_q *<= )later_left;/\1left_q;/'
mutant pipegs_control_registers "an address is shown in lines" 's/(30.d0, error_line\} << )6/\10/'

# --- parts left out ---------------------------------------------------------------------------------------------------
group lean "Machines without index ties and without overflow (\`index_ties = 0\`, \`overflow = 0\`)"
mutant su_key "depth sorted downwards" 's/order = splat_i\.depth/order = ~splat_i.depth/' su_merge_lean
mutant su_merge "assertion: > becomes >=" 's/key > key_q/key >= key_q/' su_merge_lean
mutant su_merge "assertion: the end of a layer is forgotten when the beat before it still waits" \
       's/\(go && !\(mark.*\)\) before_q/(go \&\& !out_valid_q) before_q/' su_merge_lean
mutant su_collect "no clock for a record that finds no room: the assertion is never looked at" \
       's/(active_o *= take) \|\| lost/\1/' su_lean
mutant pu_allocate "lines are given although older ones lie there" "s/SumW'\(used_q\) \+ //" pu_allocate_lean
mutant pu_allocate "assertion: the Gaussian's own lines are not counted" \
       "s/^( +SumW'\(own_q\)) \+ SumW'\(count_q\)( <=)/\1\2/" pu_allocate_lean
mutant pu_spill "assertion: looks at a flag that is 0 where nothing goes to memory" \
       's/\|\| !alphas_i\.ext/|| !ext/' pu_spill_lean
mutant pu_spill "an end waits for a memory that nobody writes to" "s/(free *= 1')b1/\1b0/" pu_spill_lean
mutant ru_fetch "assertion: looks at a flag that is 0 where nothing lies in memory" \
       's/\|\| !in_i\.ext/|| !ext/' ru_fetch_lean
mutant ru_fetch "a line of memory is always wanted" \
       "s/(\{external_want, external_valid, mem_valid_o\} = )'0/\13'b100/" ru_fetch_lean

# --- rtl/mem ----------------------------------------------------------------------------------------------------------
group mem "AXI4 manager"
mutant pipegs_axi_fence "no read waits for writes" "s/(passes *= ).*/\11'b1;/" axi_manager_512
mutant pipegs_axi_fence "a read that waits leaves as soon as it shows" \
       "s/since >= StampW'\(writes_i\)/1'b1/" axi_manager_512
mutant pipegs_axi_fence "a read passes others of its tag that wait" "s/waiting == '0 && //" axi_manager_512
mutant pipegs_axi_fence "one write too few is waited for" "s/since >= StampW/since + 1'b1 >= StampW/" axi_manager_512
mutant pipegs_axi_manager "the last tag that may write is not fenced" \
       "s/TagW'\(pipegs_pkg::WritePorts\)/TagW'(pipegs_pkg::WritePorts - 1)/" axi_manager_512
mutant pipegs_axi_manager "nothing is pending when only writes are unanswered" \
       "s/writes != '0 \|\| reads_pending/reads_pending/" axi_manager_512
mutant pipegs_axi_read "answers to the old core are shown" 's/ && m_axi_i.r.id\[IdW-1\] == epoch_i//' axi_manager_512
mutant pipegs_axi_read "more reads than Reads" "s/(room_o *= ).*/\11'b1;/" axi_manager_512
mutant pipegs_axi_read "drained as soon as the epoch turns" 's/(if \(turn\) old_q <= ).*/\1'"'0;/" axi_manager_512
mutant pipegs_axi_read "one beat too few" "s/ - 8'd1;/ - 8'd2;/" axi_manager_128
mutant pipegs_axi_read "the base does not count" 's/base_i\[AddrW-1:12\] \+ //' axi_manager_256
mutant pipegs_axi_gather "one counter for all tags" "s/port = beat_tag_i\[PortW-1:0\]/port = '0/" axi_manager_128
mutant pipegs_axi_gather "half a line of the old core is completed for the new one" \
       "s/else if \(turn_i\) beats_q <= '0;//" \
       axi_manager_128
mutant pipegs_axi_gather "half a line stands above only" 's/half_q \? last_q : parts/parts/' axi_manager_256_coded
mutant pipegs_axi_gather "half a line waits for all beats" 's/(last = )half \|\| /\1/' axi_manager_128_coded
mutant pipegs_axi_gather "the last beat stands first" 's/\{last_q, parts\}/{parts, last_q}/' axi_manager_256
mutant pipegs_axi_write "WLAST one beat early" "s/BeatW'\(Beats - 1\)/BeatW'(Beats - 2)/" axi_manager_128
mutant pipegs_axi_write "data changes while it waits" \
       's/else if \(m_axi_i.w_ready\) data_q/else data_q/' axi_manager_256
mutant pipegs_axi_write "the strobes of the first beat are those of all" \
       's/written_q >> StepW/written_q/' axi_manager_256
mutant pipegs_axi_write "a half of a line is written whole" "s/in_halves_i\[1\]/1'b1/" axi_manager_512
mutant pipegs_axi_write "errors of the old core's writes are told" 's/ && done_epoch == epoch_i//' axi_manager_512
mutant pipegs_axi_read "a read that is not taken is not owed" "s/(out_q \+ ReadsW'\()in_valid_i && free/\1asks/" \
       axi_manager_512
mutant pipegs_axi_read "a read that was answered is told as owed" \
       "s/answered && m_axi_i.r.id == owed_id_q/1'b0/" axi_manager_512
mutant pipegs_axi_read "the line that is owed is told with the base" 's/ - base_i\[AddrW-1:12\]//' axi_manager_512
mutant pipegs_axi_write "a beat that leaves is nothing that moves" 's/ \|\| \(w_valid_q && m_axi_i.w_ready\)//' \
       axi_manager_128
mutant pipegs_axi_read "errors of the old core's reads are told" \
       's/(error_o *= )now && /\1m_axi_i.r_valid \&\& /' axi_manager_512
mutant pipegs_axi_manager "of two errors in a cycle the read's is lost" \
       's/read_error && read_decode/!write_error \&\& &/' axi_manager_512
mutant pipegs_axi_manager "a write that nothing answers is told as one that failed" \
       's/write_error && !write_decode/write_error/' axi_manager_512
mutant pipegs_axi_manager "the line shown with an error is that of now" \
       's/(error_line_o = )error_line_q/\1write_line/' \
       axi_manager_512

# --- rtl: control at the top ------------------------------------------------------------------------------------------
group top "Control at the top"
mutant pipegs_perf "counts state 3 also while nothing runs" "s/if \(running_q\)/if (running_q || state_q == 2'd3)/"
mutant pipegs_perf "a restart clears three of the four counts" '/if \(restart_q\)/,/end/s/i < 4/i < 3/'
mutant pipegs_layer_free "one RU's pulse frees a layer" "s/some == '1/some != '0/"
mutant pipegs_layer_free "counters of one bit: no drift of two layers" 's/(CountW *= ).*;/\11;/'
mutant pipegs_errors "an error is told in every cycle" 's/found & ~known_q/found/' errors_unit
mutant pipegs_errors "what comes second changes the line" 's/found\[1\] && !known_q\[1\]/found[1]/' errors_unit
mutant pipegs_errors "the pixels of the last window need no room" "s/NumberW'\(1\);/NumberW'(0);/" errors_unit
mutant pipegs_errors "raster order: the row below the frame needs room" "s/rows_q - 1'b1/rows_q/" errors_unit
mutant pipegs_errors "raster order: the last line needs no room" \
       "s/(>> InLine\)) \+ NeedW'\(1\)/\1/" errors_unit
mutant pipegs_errors "raster order: rows below the image need room" "s/(rows_q +<= ).*;/\1SizeW'(below);/" errors_unit
mutant pipegs_errors "raster order: as much room as by windows" "s/by_windows_i \?/1'b1 ?/" errors_unit
mutant pipegs_errors "a bad scene stops nothing" \
       "s/(stop_o *= known_q)/\1[0]/; s/stop_o(.*) != '0/stop_o\1/" errors_unit
mutant pipegs_scheduler "one complete RU ends the frame" \
       "s/complete == '1 && !back_busy_i/complete != '0 \&\& !back_busy_i/"
mutant pipegs_scheduler "a frame ends while pixels are on their way" 's/ && !storing_i;/;/'
mutant pipegs_scheduler "windows counted in the width of a column" 's/(CountW *= )2 \* WindowW \+ 2/\1WindowW + 1/'
mutant pipegs_scheduler "a frame is taken before the back has begun the one in the front" \
       's/!front_q && !ahead_q && \(\(/!front_q \&\& ((/' scheduler_late
mutant pipegs_scheduler "splats of the next frame are let in" "s/(hold_o *= )enter_q == '0/\11'b0/"
mutant pipegs_scheduler "the RUs are heard while they finish the frame before" 's/(listen_o *= )!ahead_q && /\1/'

# --- what units say that they do --------------------------------------------------------------------------------------
group states "States of the units (\`perf_o\`), against what stands at their borders"
mutant dopu_activity "busy reads as starved" 's/(moved_i \? pipegs_pkg::)PerfBusy/\1PerfStarved/' machine_live
mutant dopu_activity "busy reads as blocked" 's/(moved_i \? pipegs_pkg::)PerfBusy/\1PerfBlocked/' machine_live
mutant dopu_activity "starved and blocked change places" \
       's/Blocked( : .*Perf)Starved/Starved\1Blocked/' machine_live
mutant pu_state "busy reads as starved" 's/(front_i\) state_o = pipegs_pkg::)PerfBusy/\1PerfStarved/' machine_live
mutant pu_state "busy reads as blocked" 's/(front_i\) state_o = pipegs_pkg::)PerfBusy/\1PerfBlocked/' machine_live
mutant pu_state "starved reads as blocked" 's/(else state_o = pipegs_pkg::)PerfStarved/\1PerfBlocked/' machine_live
mutant pipegs_su "busy reads as starved" 's/(moves\) perf_o = pipegs_pkg::)PerfBusy/\1PerfStarved/' machine_live
mutant pipegs_su "busy reads as blocked" 's/(moves\) perf_o = pipegs_pkg::)PerfBusy/\1PerfBlocked/' machine_live
mutant pipegs_su "starved reads as blocked" 's/^( +perf_o = pipegs_pkg::)PerfStarved/\1PerfBlocked/' machine_live
mutant pipegs_su "blocked reads as starved" \
       's/(ready_i\) perf_o = pipegs_pkg::)PerfBlocked/\1PerfStarved/' su
mutant pipegs_su "what the sorter does does not count" 's/(moves += gather_moves) \|\| sort_moves/\1/' machine_live
mutant pipegs_ru "busy reads as starved" 's/(moves \? pipegs_pkg::)PerfBusy/\1PerfStarved/' machine_live
mutant pipegs_ru "busy reads as blocked" 's/(moves \? pipegs_pkg::)PerfBusy/\1PerfBlocked/' machine_live
mutant pipegs_ru "starved and blocked change places" \
       's/Blocked( : pipegs_pkg::Perf)Starved/Starved\1Blocked/' machine_live
mutant pipegs_ru "pixels that begin do not count" 's/(moves += )issue \|\| /\1/' machine_live
mutant pipegs_ru "a line that leaves does not count" 's/ \|\| \(store_valid && store_ready\)//' machine_live
# --- what only whole frames cover -------------------------------------------------------------------------------------
group machine "Modules that only whole frames cover, in small machines"
mutant pu_marks "a layer's end keeps the depth that it had" \
       "s/if \(splat_is_end\) splat_o/if (1'b0) splat_o/" machine_live
mutant pu_late "regions that are done stay" 's/tiles_i\.mask & ~part_done/tiles_i.mask/' machine_live
mutant pu_late "a Gaussian without a region asks for its colour" "s/( drop *= ).*;/\11'b0;/" machine_live
mutant pu_front "asleep while Gaussians are in the cull" \
       's/(culls_o = )decode_busy \|\| cull_busy \|\| /\1/' machine_live
mutant pu_shape "asleep while Gaussians are in it" "s/(busy_o *= )\|busy/\11'b0/" machine_live
mutant pu_back "asleep while splats are made" 's/(busy_o *= )window_busy \|\| /\1/' machine_live
mutant pipegs_pu "a line from memory does not wake it" 's/^( +)geometry_rsp_valid_i \|\| /\1/' machine_live
mutant pipegs_front "done while PUs work" "s/dopu_busy \|\| pu_busy != '0/dopu_busy/" machine_live
mutant pipegs_sorting "buckets begin an octave too far" "s/ExpW'\(length - 1'b1\)/ExpW'(length)/" machine_live
mutant pipegs_raster "done while RUs blend" "s/(busy_o = )ru_active != '0 \|\| /\1/" machine_live
mutant pipegs_top "pixels by windows have the room of those in raster order" \
       's/(pixels_room = )(front_picture_q\.format)/\1!\2/' machine_live
mutant pipegs_memory_ports "pixels that the memory has not taken are stored" \
       "s/mem_valid_o && mem_request_o\.write && /1'b0 \&\& /" machine_live
mutant pipegs_host "an abort gives nothing up" 's/(give_up *= )abort \|\| /\1/' machine_live
mutant ru_rows "done of the window before is used" "s/(live *= )ends_q == '0 \? (.*) : .*;/\1\2;/" machine_lists

# --- rtl/lib ----------------------------------------------------------------------------------------------------------
group lib "Library"
mutant pipegs_fifo "accepts a word when full" 's/(push *= in_valid_i) && in_ready_o/\1/'
mutant pipegs_saturate "beyond the range the sign is kept twice" 's/\{!in_i\[InW-1\]\}/{in_i[InW-1]}/'
mutant pipegs_stream_check "what was taken must stay, too" 's/(waits_q <= valid_i) & ~ready_i/\1/'
mutant pipegs_stream_check "of several valids any one may fall" \
       "s/(gone = )\(waits_q & ~valid_i\) != '0/\1(waits_q \& ~valid_i) == '1/"
mutant pipegs_stream_check "a beat that some wait for is compared for the first one only" \
       "s/Beats'\(waits_q != '0\)/waits_q[0]/" stream_check_shared
mutant pipegs_normalize "the largest shift is one less" 's/( < DataW)\)/\1 - 1)/'
mutant pipegs_first_set "lowest bit: negation for two's complement" "s/~mask_i \+ 1'b1/~mask_i/"
mutant pipegs_bit_length "the place of the bit, counted from 0" "s/LengthW'\(i \+ 1\)/LengthW'(i)/"
mutant pipegs_window_walk "a row of windows starts at 0 instead of the first one" \
       "s/(next_x_o *= )start_i \|\| row_ends_o \? first_x_i/\1start_i ? first_x_i : row_ends_o ? '0/" ru
mutant pipegs_clock_gate "no clock in reset" 's/(enable_q = .*) \|\| !rst_ni/\1/'
mutant pipegs_clock_gate "the latch is open all the time" 's/if \(!clk_i\) enable_q/enable_q/'
mutant pipegs_clock_gate "a clock that never stops stops in reset" \
       's/clk_o = clk_i;/clk_o = clk_i \& rst_ni;/' clock_gate_free
mutant pipegs_reset_sync "the reset comes with the clock" 's/ or negedge rst_ni//'
mutant pipegs_reset_sync "one flip-flop" "s/\{release_q\[0\], 1'b1\}/2'b11/"
mutant pipegs_reset_sync "in the scan test the flip-flops stay in the way" 's/test_mode_i \? rst_ni : //'
mutant pipegs_sram "the output changes without a read" 's/if \(read_i\) rdata_o/rdata_o/'
mutant pipegs_sram "a read of the word that is written shows the new one" 's/(rdata_o <= )DataW.*;/\1wdata_i;/'
mutant pipegs_sram "such a read shows the same each time" 's/(noise_q <= )noise_q .*;/\1noise_q;/'
mutant pipegs_sram "assertion: two ports are one port, too" 's/(Ports == )2/\11/' sram_one_port

# --- rtl/list ---------------------------------------------------------------------------------------------------------
group list "Lists (\`order = 1\`), parts (\`window = 128\`)"
mutant pu_span "an endless Gaussian does not reach the last window" \
       's/endless \|\| last > limit/last > limit/' pu_expand
mutant pu_expand "the PU may fall asleep while windows are passed over" \
       's/(passes_o *= )move && !touches/\1 1'"'"'b0/' pu_expand_oriented
mutant pu_expand "a window that is passed over waits for the taker" 's/out_free \|\| !touches/out_free/' \
       pu_expand_oriented
mutant pu_parts "a Gaussian comes for a part that is not walked" 's/\|\| \(one_part &&/|| (1'"'"'b0 \&\&/' pu_parts
mutant pu_parts "a mean keeps its place in the second row of parts" \
       's/(moved_y = .*) -$/\1 + 0 */' pu_parts
mutant pu_parts "the second row begins with its second part" 's/last_column \? from_x_q : /last_column ? to_x_q : /'
mutant pu_parts "the payload of a Gaussian without a part stays" \
       's/payload_take  = conic_ready_o && data/payload_take  = conic_ready_o \&\& data \&\& !none/'
mutant ru_place "column and row of a square change places" \
       's/square_row, square_column, row/square_column, square_row, row/' \
       ru_live_parts
mutant pu_compensate "rounding: one is not added" "s/ \+ FallW'\(1\)//" pu_shape_open
mutant pipegs_log2 "rounding: half becomes one" 's/<< \(DropF - 1\)/<< DropF/'
mutant pu_lines "an end leaves before the rows have ended" 's/ && \(!is_end \|\| ended_q\)//'
mutant pipegs_list_write "the count of the record before is not yet in the memory" 's/(same_q *<= )move && .*;/\10;/'
mutant pipegs_list_write "a list runs into the next one" "s/ \|\| entry >> log_o != '0//"
mutant pipegs_list_write "where no list has room, each has one line" "s/none \|\| entry/entry/"
mutant pipegs_list_write "goes on behind a full list" 's/(out_valid_q) && !full_q/\1/'
mutant pipegs_list_room "one window less counts" "s/SpanW'\(windows_i\) << 1/SpanW'(windows_i - 1'b1) << 1/" list_write
mutant pipegs_list_write "a waiting line is overwritten" \
       's/held_valid_q && \(!out_valid_q \|\| mem_ready_i\)/held_valid_q/'
mutant pipegs_list_read "a record goes to all" "s/give \? \(item_read \? target : '1\)/give ? ('1)/"
mutant pipegs_list_read "an entry waits until an SU has room" \
       "s/(request    = )able == '0 && none_q == '1 \? '1 : able/\1able/"
mutant pipegs_list_read "one window too many" "s/windows - LeftW'\(1\)/windows/"
mutant pipegs_lists "counts are read at the window that is written" \
       's/write_count_read \? write_number : read_number/write_number/' lists
mutant pipegs_lists "the second phase begins in every cycle" 's/(written_o *= done) && !written_q/\1/' lists
