#include "app/importer/ply/PlyHeader.h"

#include "app/importer/files/AssimpValues.h"

#include <array>
#include <charconv>
#include <utility>

namespace rubble {
namespace {

std::vector<std::string> wordsOf(std::string_view line) {
    constexpr std::string_view kSpaces = " \t";
    std::vector<std::string> words;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
        if (line.empty()) return words;
        const std::size_t end = std::min(line.find_first_of(kSpaces), line.size());
        words.emplace_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

std::optional<PlyType> typeOf(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{{"char", PlyType::Int8},
                                                                           {"int8", PlyType::Int8},
                                                                           {"uchar", PlyType::Uint8},
                                                                           {"uint8", PlyType::Uint8},
                                                                           {"short", PlyType::Int16},
                                                                           {"int16", PlyType::Int16},
                                                                           {"ushort", PlyType::Uint16},
                                                                           {"uint16", PlyType::Uint16},
                                                                           {"int", PlyType::Int32},
                                                                           {"int32", PlyType::Int32},
                                                                           {"uint", PlyType::Uint32},
                                                                           {"uint32", PlyType::Uint32},
                                                                           {"float", PlyType::Float32},
                                                                           {"float32", PlyType::Float32},
                                                                           {"double", PlyType::Float64},
                                                                           {"float64", PlyType::Float64}}};
    for (const auto& [name, type] : kTypes)
        if (word == name) return type;
    return std::nullopt;
}

bool isInteger(PlyType type) { return type < PlyType::Float32; }

/// property float x, or property list uchar int vertex_indices
std::optional<PlyProperty> propertyOf(const std::vector<std::string>& words) {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (!isList && words.size() != 3) return std::nullopt;
    const std::optional<PlyType> type = typeOf(words[isList ? 3 : 1]);
    const std::optional<PlyType> size = isList ? typeOf(words[2]) : std::nullopt;
    if (!type || (isList && (!size || !isInteger(*size)))) return std::nullopt;
    return PlyProperty{words.back(), *type, size};
}

/// element vertex 8
std::optional<PlyElement> elementOf(const std::vector<std::string>& words) {
    if (words.size() != 3) return std::nullopt;
    PlyElement element{.name = words[1]};
    const char* end = words[2].data() + words[2].size();
    const auto read = std::from_chars(words[2].data(), end, element.count);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(element) : std::nullopt;
}

std::optional<PlyEncoding> encodingOf(const std::vector<std::string>& words) {
    if (words.size() != 3) return std::nullopt;
    if (words[1] == "ascii") return PlyEncoding::Ascii;
    if (words[1] == "binary_little_endian") return PlyEncoding::LittleEndian;
    return words[1] == "binary_big_endian" ? std::optional(PlyEncoding::BigEndian) : std::nullopt;
}

/// Adds what a line of the header says. Returns false if it is invalid.
bool addLine(const std::vector<std::string>& words, PlyHeader& header, bool& hasEncoding) {
    const std::string keyword = words.empty() ? "comment" : words[0];
    if (keyword == "comment" || keyword == "obj_info") return true;
    if (keyword == "format") {
        const std::optional<PlyEncoding> encoding = encodingOf(words);
        hasEncoding = encoding.has_value();
        header.encoding = encoding.value_or(PlyEncoding::Ascii);
        return hasEncoding;
    }
    if (keyword == "element") {
        std::optional<PlyElement> element = elementOf(words);
        if (element) header.elements.push_back(std::move(*element));
        return element.has_value();
    }
    if (header.elements.empty()) return keyword != "property";  // some programs write their name here
    std::optional<PlyProperty> property = keyword == "property" ? propertyOf(words) : std::nullopt;
    if (!property) return false;
    header.elements.back().properties.push_back(std::move(*property));
    return true;
}

Error headerError(const std::string& what) { return {ErrorCode::BadInput, what}; }

}  // namespace

std::size_t sizeOf(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> readPlyHeader(std::string_view file) {
    if (!file.starts_with("ply\n") && !file.starts_with("ply\r\n"))
        return headerError("the file does not begin with \"ply\"");
    PlyHeader header{.size = file.find('\n') + 1};
    bool hasEncoding = false;
    for (std::size_t number = 2;; ++number) {
        const std::size_t end = file.find('\n', header.size);
        if (end == std::string_view::npos) return headerError("the header has no line \"end_header\"");
        std::string_view line = file.substr(header.size, end - header.size);
        header.size = end + 1;
        if (line.ends_with('\r')) line.remove_suffix(1);
        const std::vector<std::string> words = wordsOf(line);
        if (words.size() == 1 && words[0] == "end_header") break;
        if (!addLine(words, header, hasEncoding))
            return headerError("line " + std::to_string(number) + " of the header, \"" + excerptOf(line) +
                               "\", is invalid");
    }
    if (!hasEncoding) return headerError("the header does not say whether the file is text or binary");
    return header;
}

}  // namespace rubble
