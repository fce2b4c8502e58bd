# Writes a C++ source that holds the bundled script and style sheet as texts.
file(READ ${SCRIPT} script)
file(READ ${STYLE} style)
foreach(text script style)
    if(${text} MATCHES "</script")
        message(FATAL_ERROR "the ${text} would end the page's script element")
    endif()
    if(${text} MATCHES "\\)suture\"")
        message(FATAL_ERROR "the ${text} contains the delimiter of the C++ text")
    endif()
endforeach()
file(WRITE ${OUTPUT} "#include \"report/scene.h\"

namespace suture::report {

const std::string& viewer_script() {
    static const std::string text = R\"suture(${script})suture\";
    return text;
}

const std::string& viewer_style() {
    static const std::string text = R\"suture(${style})suture\";
    return text;
}

}  // namespace suture::report
")
