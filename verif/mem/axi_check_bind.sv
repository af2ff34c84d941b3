// SPDX-License-Identifier: Apache-2.0
// axi_check_bind: puts the checker of the proofs (synth/prove/parts/axi_check.sv) into pipegs_axi_manager.

bind pipegs_axi_manager axi_check #(.Reads(Reads), .Writes(Writes)) u_check (
  .clk_i, .rst_ni, .pick_i(1'b1), .manager_i(m_axi_o), .subordinate_i(m_axi_i),
  .manager_o(), .subordinate_o(), .reads_o(), .reads_of_o(), .addresses_o(), .lines_o(), .beat_o()
);
