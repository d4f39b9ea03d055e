# sh clock.sh FILE: appends the processor time (ns) that the engine which called this has used so far
pid=$PPID
while ! grep -q '^liggghts' "/proc/$pid/comm"; do
  pid=$(cut -d ' ' -f 4 "/proc/$pid/stat")
  if [ "${pid:-0}" -le 1 ]; then
    echo "clock.sh: no program named liggghts called this; name the engine so" >&2
    exit 1
  fi
done
cut -d ' ' -f 1 "/proc/$pid/schedstat" >>"$1"
