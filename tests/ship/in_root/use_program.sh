# use_program.sh PROGRAM: what a user does first, with every library that is loaded on demand.
set -eu
suture=$1
folder=$(dirname "$(dirname "$(readlink -f "$suture")")")
"$suture" --version
"$suture" fill suitcase_corner.step -o filled.step --report filled.html | tail -1
"$suture" check filled.step | tail -1
"$suture" fill suitcase_corner.step --method occt -o by_occt.igs | tail -1 || [ $? = 4 ]
"$suture" convert filled.step filled.3mf
"$suture" convert filled.step filled.stl
"$suture" inspect by_occt.igs | tail -1 || [ $? = 3 ]
"$suture" demo --out demo | tail -1 || [ $? = 4 ]
ls demo/*.html demo/*.step >/dev/null
grep -q '<canvas\|viewer' filled.html
# Nothing but the C library comes from outside of the folder.
if [ -d "$folder/lib/suture" ] && [ -e "$folder/share/doc/suture/suture.spdx.json" ]; then
    for file in "$folder/bin/suture" "$folder"/lib/suture/suture_*; do
        foreign=$(ldd "$file" | grep '=> /' | grep -v "$folder\|/$(basename "$file")" |
            grep -vE '/(libc|libm|libpthread|libdl|librt|libresolv|libmvec)\.so' || true)
        case $file in
            *.so) ;; # the program's run path serves its modules
            *) [ -z "$foreign" ] || { echo "$file takes from the system: $foreign"; exit 1; } ;;
        esac
    done
fi
echo "used: well"
