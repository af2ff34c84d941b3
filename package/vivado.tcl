# SPDX-License-Identifier: Apache-2.0
# Printed by package/machine.py (`make package`): change that, never this file.
#
# vivado -mode batch -source package/vivado.tcl, from the root of the project: packs the core as an IP in
# build/ip. Vivado finds the AXI interfaces by the names of the ports. Another list of files, of
# package/machine.py: -tclargs FOLDER/pipegs.f.
create_project -in_memory
set list [open [expr {$argc > 0 ? [lindex $argv 0] : {package/pipegs.f}}]]
read_verilog -sv [regexp -all -inline -line {^.*[.]sv$} [read $list]]
close $list
set_property top pipegs_axi [current_fileset]
ipx::package_project -root_dir build/ip -vendor pipegs -library core -taxonomy /Video -import_files -force
set core [ipx::current_core]
set_property name pipegs $core
set_property version 3.1 $core
foreach bus {s_axi m_axi} { ipx::associate_bus_interfaces -busif $bus -clock aclk $core }
set reset [ipx::get_bus_interfaces aresetn -of_objects $core]
set_property value ACTIVE_LOW [ipx::add_bus_parameter POLARITY $reset]
ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
