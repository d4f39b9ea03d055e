# sh clock.sh FILE: appends the processor time (ns) that the engine which called this has used so far
pid=$PPID
while ! grep -q '^liggghts' "/proc/$pid/comm"; do
  pid=$(cut -d ' ' -f 4 "/proc/$pid/stat")
done
cut -d ' ' -f 1 "/proc/$pid/schedstat" >>"$1"
