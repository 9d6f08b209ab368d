#include "core/io/exchange/UsdWriter.h"

#include "core/base/Assert.h"
#include "core/base/Utf8.h"
#include "core/io/text/NumberText.h"

#include <utility>

namespace rubble {
namespace {

bool isUsdLetter(char letter) { return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z'); }
bool isUsdDigit(char letter) { return letter >= '0' && letter <= '9'; }
bool continuesCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

std::string usdIdentifier(std::string_view name) {
    std::string result;
    for (const char letter : name) {
        if (isUsdDigit(letter) && result.empty()) result += '_';
        if (isUsdLetter(letter) || isUsdDigit(letter))
            result += letter;
        else if (!continuesCharacter(letter))
            result += '_';
    }
    return result.empty() ? "_" : result;
}

}  // namespace

std::string UsdNames::unique(std::string_view name) {
    const std::string own = usdIdentifier(name);
    std::string result = own;
    for (std::uint32_t number = 2; !m_taken.insert(result).second; ++number)
        result = own + "_" + std::to_string(number);
    return result;
}

UsdWriter::UsdWriter(std::string_view defaultPrim, std::string_view documentation,
                     const std::optional<UsdTimes>& times) {
    m_text = "#usda 1.0\n(\n    defaultPrim = ";
    addQuoted(defaultPrim);
    m_text += "\n    doc = ";
    addQuoted(documentation);
    if (times) {
        m_text += "\n    endTimeCode = ";
        appendNumber(m_text, times->last);
    }
    m_text += "\n    kilogramsPerUnit = 1\n    metersPerUnit = 1";
    if (times) {
        m_text += "\n    startTimeCode = 0\n    timeCodesPerSecond = ";
        appendNumber(m_text, times->perSecond);
    }
    m_text += "\n    upAxis = \"Y\"\n)\n";
}

std::string UsdWriter::begin(std::string_view type, std::string_view name,
                             std::initializer_list<std::string_view> apis) {
    m_text += '\n';
    indent();
    m_text.append("def ").append(type).append(" \"").append(name).append("\"");
    if (apis.size() > 0) {
        m_text += " (\n";
        indent();
        m_text += "    prepend apiSchemas = [";
        const char* separator = "";
        for (const std::string_view api : apis) {
            m_text += std::exchange(separator, ", ");
            addQuoted(api);
        }
        m_text += "]\n";
        indent();
        m_text += ')';
    }
    m_text += '\n';
    indent();
    m_text += "{\n";
    m_path.emplace_back(name);
    std::string path;
    for (const std::string& each : m_path) path += "/" + each;
    return path;
}

void UsdWriter::end() {
    RUBBLE_ASSERT(!m_path.empty());
    m_path.pop_back();
    indent();
    m_text += "}\n";
}

void UsdWriter::indent() { m_text.append(4 * m_path.size(), ' '); }

void UsdWriter::declare(std::string_view declaration) {
    indent();
    m_text.append(declaration).append(" = ");
}

void UsdWriter::addQuoted(std::string_view text) {
    constexpr std::string_view kHexDigits = "0123456789abcdef";
    m_text += '"';
    for (const char letter : wellFormed(text)) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\')
            m_text.append(1, '\\').append(1, letter);
        else if (letter == '\n')
            m_text += "\\n";
        else if (byte < 0x20)
            m_text.append("\\x").append(1, kHexDigits[byte >> 4u]).append(1, kHexDigits[byte & 15u]);
        else
            m_text += letter;
    }
    m_text += '"';
}

void UsdWriter::addTuple(std::initializer_list<double> values) {
    const char* separator = "(";
    for (const double value : values) {
        m_text += std::exchange(separator, ", ");
        appendFloat(m_text, value);
    }
    m_text += ')';
}

void UsdWriter::addOutput(std::string_view declaration) {
    indent();
    m_text.append(declaration).append(1, '\n');
}

void UsdWriter::setWord(std::string_view declaration, std::string_view value) {
    declare(declaration);
    m_text.append(value).append(1, '\n');
}

void UsdWriter::setDouble(std::string_view declaration, double value) {
    declare(declaration);
    appendNumber(m_text, value);
    m_text += '\n';
}

void UsdWriter::setFloat(std::string_view declaration, double value) {
    declare(declaration);
    appendFloat(m_text, value);
    m_text += '\n';
}

void UsdWriter::setText(std::string_view declaration, std::string_view value) {
    declare(declaration);
    addQuoted(value);
    m_text += '\n';
}

void UsdWriter::setAsset(std::string_view declaration, std::string_view file) {
    declare(declaration);
    m_text.append("@./").append(file).append("@\n");
}

void UsdWriter::setTarget(std::string_view declaration, std::string_view path) {
    declare(declaration);
    m_text.append("<").append(path).append(">\n");
}

void UsdWriter::setDoubles(std::string_view declaration, Vec3 value) {
    declare(declaration);
    const char* separator = "(";
    for (int axis = 0; axis < 3; ++axis) {
        m_text += std::exchange(separator, ", ");
        appendNumber(m_text, value[axis]);
    }
    m_text += ")\n";
}

void UsdWriter::setFloats(std::string_view declaration, Vec3 value) {
    declare(declaration);
    addTuple({value.x, value.y, value.z});
    m_text += '\n';
}

void UsdWriter::setRotation(std::string_view declaration, const Quat& rotation) {
    declare(declaration);
    addTuple({rotation.w, rotation.x, rotation.y, rotation.z});
    m_text += '\n';
}

void UsdWriter::setTexts(std::string_view declaration, std::initializer_list<std::string_view> values) {
    declare(declaration);
    const char* separator = "[";
    for (const std::string_view value : values) {
        m_text += std::exchange(separator, ", ");
        addQuoted(value);
    }
    m_text += "]\n";
}

void UsdWriter::setIndices(std::string_view declaration, std::span<const std::uint32_t> values) {
    declare(declaration);
    m_text += '[';
    const char* separator = "";
    for (const std::uint32_t value : values) {
        m_text += std::exchange(separator, ", ");
        appendNumber(m_text, value);
    }
    endArray(UsdInterpolation::None);
}

void UsdWriter::setPoints(std::string_view declaration, std::span<const Vec3> values, UsdInterpolation interpolation) {
    declare(declaration);
    m_text += '[';
    const char* separator = "";
    for (const Vec3& value : values) {
        m_text += std::exchange(separator, ", ");
        addTuple({value.x, value.y, value.z});
    }
    endArray(interpolation);
}

void UsdWriter::setPoints(std::string_view declaration, std::span<const Vec2> values, UsdInterpolation interpolation) {
    declare(declaration);
    m_text += '[';
    const char* separator = "";
    for (const Vec2& value : values) {
        m_text += std::exchange(separator, ", ");
        addTuple({value.x, value.y});
    }
    endArray(interpolation);
}

void UsdWriter::endArray(UsdInterpolation interpolation) {
    m_text += ']';
    if (interpolation == UsdInterpolation::FaceVarying) m_text += " (interpolation = \"faceVarying\")";
    m_text += '\n';
}

void UsdWriter::beginSamples(std::string_view declaration) {
    declare(std::string(declaration) + ".timeSamples");
    m_text += "{\n";
}

void UsdWriter::beginSample(std::uint32_t time) {
    indent();
    m_text += "    ";
    appendNumber(m_text, time);
    m_text += ": ";
}

void UsdWriter::addSample(std::uint32_t time, std::string_view value) {
    beginSample(time);
    m_text.append(value).append(",\n");
}

void UsdWriter::addSample(std::uint32_t time, Vec3 value) {
    beginSample(time);
    addTuple({value.x, value.y, value.z});
    m_text += ",\n";
}

void UsdWriter::addSample(std::uint32_t time, const Quat& value) {
    beginSample(time);
    addTuple({value.w, value.x, value.y, value.z});
    m_text += ",\n";
}

void UsdWriter::endSamples() {
    indent();
    m_text += "}\n";
}

std::string UsdWriter::text() && {
    RUBBLE_ASSERT(m_path.empty());
    return std::move(m_text);
}

}  // namespace rubble
