# bash tests/in_fresh_folder.sh FOLDER COMMAND...: runs COMMAND in FOLDER, emptied before
set -eu
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
exec "$@"
