#include "app/importer/obj/ObjContent.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/TextWords.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace rubble {
namespace {

/// The lines of a text without what ends them; a line that ends with a backslash goes on in the next one.
class Lines {
public:
    explicit Lines(std::string_view text) : m_rest(text) {}

    /// Sets the next line; false at the end of the text.
    bool next(std::string_view& line) {
        if (m_rest.empty()) return false;
        line = oneLine();
        if (!line.ends_with('\\')) return true;
        m_joined.clear();
        while (line.ends_with('\\')) {
            m_joined.append(line.substr(0, line.size() - 1)).append(" ");
            line = m_rest.empty() ? std::string_view() : oneLine();
        }
        line = m_joined.append(line);
        return true;
    }
    std::size_t number() const { return m_number; }

private:
    std::string_view oneLine() {
        ++m_number;
        const std::size_t end = std::min(m_rest.find_first_of("\r\n"), m_rest.size());
        const std::string_view line = m_rest.substr(0, end);
        const bool isCrLf = m_rest.substr(end).starts_with("\r\n");
        m_rest.remove_prefix(std::min(end + (isCrLf ? 2 : 1), m_rest.size()));
        return line;
    }

    std::string_view m_rest;
    std::string m_joined;
    std::size_t m_number = 0;
};

/// Finds names again in the order of their first mention.
class Names {
public:
    std::uint32_t indexOf(const std::string& name) {
        return m_indices.try_emplace(name, static_cast<std::uint32_t>(m_indices.size())).first->second;
    }
    std::size_t size() const { return m_indices.size(); }

private:
    std::map<std::string, std::uint32_t> m_indices;
};

class ObjParser {
public:
    explicit ObjParser(std::string_view text) : m_lines(text), m_text(text) {}

    ObjContent file() {
        m_file.hasObjects = hasObjects(m_text);
        material("");
        for (std::string_view line; m_lines.next(line);) readLine(line);
        return std::move(m_file);
    }

private:
    static bool hasObjects(std::string_view text) {
        Lines lines(text);
        for (std::string_view line; lines.next(line);)
            if (takeWord(line) == "o") return true;
        return false;
    }

    void readLine(std::string_view line) {
        std::string_view rest = line;
        const std::string_view word = takeWord(rest);
        if (word == "v") {
            m_file.points.push_back(numbers<3>(rest, line));
        } else if (word == "vt") {
            m_file.uvs.push_back(uvOf(rest, line));
        } else if (word == "f" || word == "fo") {
            addFace(rest, line);
        } else if (word == "o" || (word == "g" && !m_file.hasObjects)) {
            beginPart(lineOf(trimmed(rest)));
        } else if (word == "usemtl") {
            m_material = material(lineOf(trimmed(rest)));
        } else if (word == "mtllib") {
            m_file.materialFiles.emplace_back(trimmed(rest));
        } else if (word == "curv" || word == "surf") {
            m_file.hasCurves = true;
        }
    }

    [[noreturn]] void fail(std::string_view line, const std::string& what) const {
        throw MeshError(ErrorCode::BadInput, "cannot be read as OBJ: line " + std::to_string(m_lines.number()) +
                                                 ", \"" + excerptOf(trimmed(line)) + "\", " + what);
    }

    double number(std::string_view& rest, std::string_view line) const {
        const std::string_view word = takeWord(rest);
        const std::optional<double> value = numberOf(word);
        if (word.empty()) fail(line, "has too few numbers");
        if (!value) fail(line, "has an invalid number");
        return *value;
    }
    template <int size>
    glm::vec<size, double> numbers(std::string_view& rest, std::string_view line) const {
        glm::vec<size, double> values;
        for (int k = 0; k < size; ++k) values[k] = number(rest, line);
        return values;
    }
    /// The second coordinate is optional.
    Vec2 uvOf(std::string_view rest, std::string_view line) const {
        Vec2 uv(number(rest, line), 0.0);
        const bool hasV = !trimmed(rest).empty() && !trimmed(rest).starts_with('#');
        if (hasV) uv.y = number(rest, line);
        return uv;
    }

    void addFace(std::string_view rest, std::string_view line) {
        if (m_file.parts.empty()) beginPart("");
        ObjFace face{
            .firstCorner = static_cast<std::uint32_t>(m_file.corners.size()), .part = m_part, .material = m_material};
        for (;;) {
            const std::string_view word = takeWord(rest);
            if (word.empty() || word.starts_with('#')) break;
            m_file.corners.push_back(corner(word, line));
            ++face.size;
        }
        if (face.size >= 3) {
            m_file.faces.push_back(face);
        } else if (face.size == 0) {
            fail(line, "has no corners");
        } else {
            m_file.corners.resize(face.firstCorner);  // a point or a line
        }
    }
    /// point, point/uv, point//normal or point/uv/normal
    ObjCorner corner(std::string_view word, std::string_view line) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const std::string_view point = word.substr(0, slash);
        const std::optional<std::uint32_t> index = indexOf(point, m_file.points.size(), line);
        if (!index) fail(line, "refers to point " + std::string(point) + " of " + std::to_string(m_file.points.size()));
        ObjCorner corner{.point = *index};
        const std::string_view more = word.substr(std::min(slash + 1, word.size()));
        const std::string_view uv = more.substr(0, more.find('/'));
        if (uv.empty()) return corner;
        corner.uv = indexOf(uv, m_file.uvs.size(), line).value_or(kNoUv);
        m_file.lacksUvs |= corner.uv == kNoUv;
        return corner;
    }
    /// Indices are from one on, or negative from the last one back. Nothing if it is out of range.
    std::optional<std::uint32_t> indexOf(std::string_view word, std::size_t count, std::string_view line) const {
        std::int64_t number = 0;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
        if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) fail(line, "has an invalid corner");
        const auto all = static_cast<std::int64_t>(count);
        if (number == 0 || number > all || number < -all) return std::nullopt;
        return static_cast<std::uint32_t>(number < 0 ? all + number : number - 1);
    }

    void beginPart(const std::string& name) {
        const auto isNew = static_cast<std::uint32_t>(m_file.parts.size());
        m_part = m_file.hasObjects ? isNew : m_groups.indexOf(name);
        if (m_part == isNew) m_file.parts.push_back({name});
    }
    std::uint32_t material(const std::string& name) {
        const std::uint32_t index = m_materials.indexOf(name);
        if (index == m_file.materials.size()) m_file.materials.push_back(name);
        return index;
    }

    Lines m_lines;
    std::string_view m_text;
    ObjContent m_file;
    Names m_groups, m_materials;
    std::uint32_t m_part = 0;
    std::uint32_t m_material = 0;
};

/// Reads what follows map_Kd: options with numbers or words, then a name that may have spaces.
ObjTexture textureOf(std::string_view rest) {
    ObjTexture texture;
    for (;;) {
        std::string_view behind = rest;
        const std::string_view option = takeWord(behind);
        const bool isVector = option == "-o" || option == "-s" || option == "-t";
        const auto isOption = [&](const char* name) { return option == name; };
        const int words = option == "-mm" ? 2
                          : std::ranges::any_of(std::array{"-blendu", "-blendv", "-boost", "-bm", "-cc", "-clamp",
                                                           "-imfchan", "-texres", "-type"},
                                                isOption)
                              ? 1
                              : 0;
        if (!isVector && words == 0) break;
        for (int k = 0; k < words; ++k) takeWord(behind);
        for (int k = 0; isVector && k < 3; ++k) {
            std::string_view next = behind;
            const std::optional<double> number = numberOf(takeWord(next));
            if (!number) break;
            texture.isTransformed |= *number != (option == "-s" ? 1.0 : 0.0);
            behind = next;
        }
        rest = behind;
    }
    texture.file = trimmed(rest);
    return texture;
}

}  // namespace

ObjContent readObjText(std::string_view text) { return ObjParser(text).file(); }

void readMaterialFile(std::string_view text, std::vector<SourceMaterial>& materials,
                      std::vector<ObjTexture>& textures) {
    Lines lines(text);
    SourceMaterial* current = nullptr;
    std::vector<bool> hasColour(materials.size(), false);
    const auto index = [&] { return static_cast<std::size_t>(current - materials.data()); };
    for (std::string_view line; lines.next(line);) {
        const std::string_view word = takeWord(line);
        if (word == "newmtl") {
            const auto found = std::ranges::find(materials, lineOf(trimmed(line)), &SourceMaterial::name);
            current = found == materials.end() ? nullptr : &*found;
        } else if (word == "map_Kd" && current != nullptr) {
            textures[index()] = textureOf(line);
        } else if (word == "Kd" && current != nullptr) {
            hasColour[index()] = true;
            for (int k = 0; k < 3; ++k) {
                const std::optional<double> part = numberOf(takeWord(line));
                if (!part || !std::isfinite(*part)) break;
                current->colour[k] = std::clamp(*part, 0.0, 1.0);
            }
        }
    }
    for (std::size_t k = 0; k < textures.size(); ++k)
        if (!textures[k].file.empty() && !hasColour[k]) materials[k].colour = Vec3(1.0);
}

}  // namespace rubble
