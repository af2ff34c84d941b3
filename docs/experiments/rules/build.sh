# The experiment's program without the rest: only what the timing model has, before the objects of an earlier build.
set -e
cd /src; mkdir -p /src/exp/obj
for f in "$@"; do
  o=/src/exp/obj/$(basename $f .cpp).o
  if [ ! -e $o ] || [ -n "$(find sim/timing $f -newer $o -name "*.?pp" | head -1)" ]; then
    clang++ -DFMT_SHARED -I/src -isystem /usr/include/OpenEXR -isystem /usr/include/Imath -O2 -ffp-contract=off -fPIC -std=c++20 -fno-access-control -c $f -o $o
  fi
done
