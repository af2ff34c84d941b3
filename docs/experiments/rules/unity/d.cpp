#include "sim/timing/trace/plan.cpp"
#include "sim/timing/trace/batch.cpp"
