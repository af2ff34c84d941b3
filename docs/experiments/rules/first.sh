cd /work/w/h4
/work/w/in h4 nice -n 15 bash -c 'time bash docs/experiments/rules/build.sh exp/unity/d.cpp sim/timing/trace/trace.cpp exp/unity/b.cpp exp/unity/a.cpp exp/unity/c.cpp && bash exp/rules/link.sh && date && bash exp/rules/run0.sh b1 showroom && bash exp/rules/run0.sh b1 statue; date'
