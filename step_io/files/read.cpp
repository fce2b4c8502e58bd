#include "files/read.h"

#include "files/bad_faces.h"
#include "files/brep.h"
#include "files/check_numbers.h"
#include "files/document.h"
#include "files/file_bytes.h"
#include "files/freecad_document.h"
#include "files/join_bodies.h"
#include "files/packed.h"
#include "files/read_iges.h"
#include "files/read_step.h"
#include "files/rigid.h"
#include "files/static_scope.h"
#include "suture/occ/guard.h"

#include <fmt/ranges.h>

#include <TopExp_Explorer.hxx>

namespace suture::io {

namespace {

bool keep_face_names = true;
bool follow_external_references = true;

Result<void> read_brep(ModelFile& model, const std::string& bytes) {
    const Result<TopoDS_Shape> shape = model.format == Format::BrepText
                                           ? read_brep_text(bytes, model.path)
                                           : read_brep_binary(bytes, model.path);
    if (!shape) {
        return tl::unexpected(shape.error());
    }
    const StaticScope names_nothing;
    shapes_of(model.document)->AddShape(with_rigid_placements(*shape), false);
    return {};
}

/// What a file holds.
struct FileContents {
    std::string text;
    bool elsewhere = false;  ///< than in a file by itself: in a packed one, or piped in
};

Result<FileContents> read_contents(const std::filesystem::path& file) {
    Result<std::string> bytes = read_bytes(file);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    if (!is_packed(*bytes)) {
        return FileContents{*std::move(bytes), file == kStandardInput};
    }
    return unpack(*std::move(bytes), file).map([](std::string&& text) {
        return FileContents{std::move(text), true};
    });
}

/// OCCT's reader of IGES takes nothing but files.
Result<void> read_iges_of(ModelFile& model, const FileContents& contents,
                          const Progress& progress) {
    if (!contents.elsewhere) {
        return read_iges(model, contents.text, model.path, progress);
    }
    const NamedBytes named(contents.text);
    return read_iges(model, contents.text, named.path(), progress);
}

Result<void> read_into(ModelFile& model, const FileContents& contents, const Progress& progress) {
    switch (model.format) {
        case Format::Step:
            // What is piped in has no folder for other files.
            return read_step(
                model, contents.text, progress,
                {keep_face_names, contents.elsewhere,
                 follow_external_references && model.path != shown_name(kStandardInput)});
        case Format::Iges:
            return read_iges_of(model, contents, progress);
        case Format::FreecadDocument:
            return read_freecad_document(model, contents.text);
        default:
            return read_brep(model, contents.text);
    }
}

/// What is wrong with a file is the file's fault, also where OCCT noticed it.
Error unreadable(const Error& error, const std::filesystem::path& file) {
    if (error.code != ErrorCode::Internal) {
        return error;
    }
    const std::string first_line = error.message.substr(0, error.message.find('\n'));
    return {ErrorCode::Unreadable, fmt::format("{} cannot be read: {}", file.string(), first_line)};
}

/// Why there is nothing to work on.
Error no_face(const ModelFile& model) {
    std::string text = fmt::format("{} holds no face", model.path.string());
    if (!model.missing_files.empty()) {
        text += fmt::format(": its parts lie in other files that are not read: {}",
                            fmt::join(model.missing_files, ", "));
    }
    for (const std::string& note : model.notes) {
        text += "; " + note;
    }
    return {ErrorCode::Unreadable, std::move(text)};
}

}  // namespace

void forget_face_names() {
    keep_face_names = false;
}

void close_external_references() {
    follow_external_references = false;
}

Result<ModelFile> read_model(const std::filesystem::path& source, const Progress& progress,
                             Content content) {
    progress(0.0, "read");
    const Result<FileContents> contents = read_contents(source);
    const std::filesystem::path file = shown_name(source);
    if (!contents) {
        return tl::unexpected(contents.error());
    }
    const Result<Format> format = format_of_bytes(contents->text, file);
    if (!format) {
        return tl::unexpected(format.error());
    }
    ModelFile model;
    model.path = file;
    model.format = *format;
    const Result<void> done = occ::guarded("reading", [&]() -> Result<void> {
        model.document = make_document();
        return read_into(model, *contents, progress)
            .and_then([&] { return check_numbers(model.shape(), file); })
            .map([&] {
                join_bodies(model.document);
                name_parts(model.document, file.stem().string());
                leave_out_bad_faces(model);
            });
    });
    if (progress.cancelled()) {
        return fail(ErrorCode::Cancelled, "reading {} was stopped", file.string());
    }
    if (!done) {
        return tl::unexpected(unreadable(done.error(), file));
    }
    const bool curves =
        content == Content::Curves && TopExp_Explorer(model.shape(), TopAbs_EDGE).More();
    if (!has_face(model.shape()) && !curves) {
        return tl::unexpected(no_face(model));
    }
    if (!model.missing_files.empty()) {
        model.notes.push_back(fmt::format("parts lie in other files that are not read: {}",
                                          fmt::join(model.missing_files, ", ")));
    }
    return model;
}

}  // namespace suture::io
