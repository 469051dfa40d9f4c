# Sourced by tests/distributions/run and tests/arm64/run, which set `folder` and `only`: a row of their table. Where `only` names
# rows, the others are passed over.
table=""
failed=0
row() {  # row NAME WHAT COMMAND...
  [[ ${#only[@]} -eq 0 || " ${only[*]} " == *" $1 "* ]] || return 0
  local log=$folder/${suite:-arm64}-$1.log what=$2 start=$SECONDS result=good
  shift 2
  echo "$what: $log"
  "$@" </dev/null >"$log" 2>&1 || { result=FAILED; failed=1; tail -n 15 "$log"; }
  table+=$(printf '%-56s %-7s %5d s' "$what" "$result" $((SECONDS - start)))$'\n'
}
