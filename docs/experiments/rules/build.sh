# The experiment's program without the rest: only what the timing model has, before the objects of an earlier build.
set -e
cd /src; mkdir -p /src/exp/obj
for f in "$@"; do
  o=/src/exp/obj/$(basename $f .cpp).o
  src=$(grep -o "\"sim/timing/[^\"]*cpp" $f | tr -d \"); h=$(find sim/timing -name "*.hpp" -newer $o 2>/dev/null | head -1); if [ ! -e $o ] || [ -n "$h" ] || [ -n "$(find $src $f -newer $o | head -1)" ]; then
    clang++ -DFMT_SHARED -I/src -isystem /usr/include/OpenEXR -isystem /usr/include/Imath -O2 -ffp-contract=off -fPIC -std=c++20 -fno-access-control -c $f -o $o
  fi
done
