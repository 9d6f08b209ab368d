#include "core/io/media/RadianceFile.h"

#include "core/base/MessageText.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

using Pixel = std::array<std::uint8_t, 4>;  // red, green, blue and their common exponent

constexpr std::size_t kMaxHeader = 65536;       // bytes
constexpr std::uint32_t kMinEncodedLength = 8;  // pixels of a line that the newer encoding can have
constexpr double kMaxFactor = 1e9;              // of exposures and colour corrections, and the inverse of the least
constexpr double kMaxRadiance = 1e30;           // leaves room for sums in single precision
constexpr float kMinRadiance = 1e-30f;          // of light
constexpr unsigned kMaxShift = 24;              // of the count of a run in the older encoding
constexpr const char* kFormat = "FORMAT=32-bit_rle_rgbe";

/// How the lines of a file make up the picture.
struct LineOrder {
    std::uint32_t lines = 0, length = 0;  // pixels a line
    bool isByColumn = false;              // a line is a column
    bool isRightToLeft = false, isBottomUp = false;

    std::uint32_t width() const { return isByColumn ? lines : length; }
    std::uint32_t height() const { return isByColumn ? length : lines; }
};

/// One axis of a resolution: "-Y 512".
struct AxisText {
    char sign = 0, axis = 0;
    std::uint32_t count = 0;
};

std::optional<std::uint32_t> wholeNumber(std::string_view text) {
    std::uint32_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || end != text.data() + text.size() || number == 0) return std::nullopt;
    return number;
}

/// Takes an axis from the front of a text.
std::optional<AxisText> takeAxis(std::string_view& text) {
    if (text.size() < 4 || (text[0] != '-' && text[0] != '+') || (text[1] != 'X' && text[1] != 'Y') || text[2] != ' ')
        return std::nullopt;
    const std::size_t end = std::min(text.find(' ', 3), text.size());
    const std::optional<std::uint32_t> count = wholeNumber(text.substr(3, end - 3));
    if (!count) return std::nullopt;
    const AxisText axis{text[0], text[1], *count};
    text.remove_prefix(end);
    return axis;
}

std::optional<LineOrder> lineOrderOf(std::string_view text) {
    const std::optional<AxisText> first = takeAxis(text);
    if (!first || !text.starts_with(' ')) return std::nullopt;
    text.remove_prefix(1);
    const std::optional<AxisText> second = takeAxis(text);
    if (!second || first->axis == second->axis || !text.empty()) return std::nullopt;
    const bool isByColumn = first->axis == 'X';
    const AxisText& x = isByColumn ? *first : *second;
    const AxisText& y = isByColumn ? *second : *first;
    return LineOrder{first->count, second->count, isByColumn, x.sign == '-', y.sign == '+'};
}

/// Numbers that are separated by spaces, in the range of factors.
template <std::size_t Count>
std::optional<std::array<double, Count>> factorsOf(std::string_view text) {
    std::array<double, Count> factors{};
    for (double& factor : factors) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), factor);
        if (fault != std::errc() || !(factor >= 1.0 / kMaxFactor && factor <= kMaxFactor)) return std::nullopt;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    if (text.find_first_not_of(' ') != text.npos) return std::nullopt;
    return factors;
}

/// The mean of the pixels of a picture that become one of a smaller one.
class Reduction {
public:
    Reduction(std::uint32_t width, std::uint32_t height)
        : m_width(std::min(width, RadianceImage::kMaxWidth)),
          m_height(m_width / 2),
          m_columns(placesOf(width, m_width)),
          m_rows(placesOf(height, m_height)),
          m_sums(std::size_t{m_width} * m_height) {}

    void add(std::uint32_t x, std::uint32_t y, const std::array<double, 3>& radiance) {
        std::array<double, 3>& sum = m_sums[std::size_t{m_rows[y]} * m_width + m_columns[x]];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += radiance[k];
    }
    RadianceImage mean() const {
        const std::vector<std::uint32_t> columns = countsOf(m_columns, m_width), rows = countsOf(m_rows, m_height);
        RadianceImage image{m_width, m_height, {}};
        image.pixels.reserve(m_sums.size());
        for (std::size_t k = 0; k < m_sums.size(); ++k) {
            const double count = static_cast<double>(columns[k % m_width]) * rows[k / m_width];
            const auto channel = [&](std::size_t c) { return static_cast<float>(m_sums[k][c] / count); };
            image.pixels.push_back({channel(0), channel(1), channel(2)});
        }
        return image;
    }

private:
    /// For each of `count` places the one among `fewer`.
    static std::vector<std::uint32_t> placesOf(std::uint32_t count, std::uint32_t fewer) {
        std::vector<std::uint32_t> places(count);
        for (std::uint32_t k = 0; k < count; ++k)
            places[k] = static_cast<std::uint32_t>(std::uint64_t{k} * fewer / count);
        return places;
    }
    static std::vector<std::uint32_t> countsOf(const std::vector<std::uint32_t>& places, std::uint32_t fewer) {
        std::vector<std::uint32_t> counts(fewer);
        for (const std::uint32_t place : places) ++counts[place];
        return counts;
    }

    std::uint32_t m_width, m_height;
    std::vector<std::uint32_t> m_columns, m_rows;
    std::vector<std::array<double, 3>> m_sums;
};

/// Above the horizon.
bool hasLight(const RadianceImage& image) {
    const auto end = image.pixels.begin() + std::ptrdiff_t{std::max(image.height / 2, 1u)} * image.width;
    return std::any_of(image.pixels.begin(), end, [](const auto& pixel) { return pixel[0] > kMinRadiance; });
}

class RadianceReader {
public:
    RadianceReader(std::string_view bytes, const std::string& name) : m_rest(bytes), m_name(quotedName(name)) {}

    Result<RadianceImage> read(const TaskContext& task) {
        if (const Status header = readHeader(); !header) return header.error();
        if (const Status size = checkSize(); !size) return size.error();
        for (int k = 0; k < 256; ++k) m_scales[static_cast<std::size_t>(k)] = k == 0 ? 0.0 : std::ldexp(1.0, k - 136);
        Reduction reduction(m_order.width(), m_order.height());
        m_line.resize(m_order.length);
        for (m_lineNumber = 0; m_lineNumber < m_order.lines; ++m_lineNumber) {
            if (task.isCancelled()) return TaskContext::cancelled();
            if (const Status line = readLine(); !line) return line.error();
            if (const Status added = addLine(reduction); !added) return added.error();
        }
        if (!m_rest.empty()) return fault("goes on after its last pixel: it is damaged. Copy or export it again.");
        RadianceImage image = reduction.mean();
        if (!hasLight(image)) return fault("is black above the horizon: it gives no light. Select another picture.");
        return image;
    }

private:
    Error fault(const std::string& what, ErrorCode code = ErrorCode::BadInput) const {
        return {code, m_name + ' ' + what};
    }
    Error lineFault(const std::string& what) const {
        return fault(what + " in line " + std::to_string(m_lineNumber + 1) + " of its " +
                     std::to_string(m_order.lines) + " lines of pixels: it is damaged. Copy or export it again.");
    }
    Error tooEarly() const { return lineFault("ends too early,"); }

    /// The next line of the header without its end.
    Result<std::string_view> takeTextLine() {
        const std::size_t end = m_rest.substr(0, kMaxHeader - m_headerBytes).find('\n');
        if (end == m_rest.npos) {
            return fault("has no end of its header in the first " + std::to_string(kMaxHeader) +
                         " bytes: it is damaged. Copy or export it again.");
        }
        const std::string_view line = m_rest.substr(0, end);
        m_rest.remove_prefix(end + 1);
        m_headerBytes += end + 1;
        return line;
    }
    Status readHeader();
    Status readVariable(std::string_view line);
    Status checkSize() const;
    Status readLine();
    Status readEncodedLine();
    Status readPlainLine();
    Status addLine(Reduction& reduction) const;

    std::string_view m_rest;  // not read yet
    std::string m_name;
    std::size_t m_headerBytes = 0;
    bool m_hasFormat = false;
    std::array<double, 3> m_factors{1.0, 1.0, 1.0};  // of the channels in the file
    LineOrder m_order;
    std::uint32_t m_lineNumber = 0;
    std::vector<Pixel> m_line;
    std::array<double, 256> m_scales{};  // of the exponents
};

Status RadianceReader::readHeader() {
    if (!m_rest.starts_with("#?")) {
        return fault("is no Radiance picture. Select an .hdr file, or convert the picture to one.",
                     ErrorCode::Unsupported);
    }
    for (;;) {
        const Result<std::string_view> line = takeTextLine();
        if (!line) return line.error();
        if (line->empty()) break;
        if (const Status read = readVariable(*line); !read) return read.error();
    }
    if (!m_hasFormat) return fault("does not name its format: it needs the line \"" + std::string(kFormat) + "\".");
    const Result<std::string_view> resolution = takeTextLine();
    if (!resolution) return resolution.error();
    const std::optional<LineOrder> order = lineOrderOf(*resolution);
    if (!order) {
        return fault("has " + quotedName(*resolution) +
                     " in place of its size, such as \"-Y 512 +X 1024\". Export it again.");
    }
    m_order = *order;
    return success();
}

Status RadianceReader::readVariable(std::string_view line) {
    if (line.starts_with("FORMAT=")) {
        if (line != kFormat) {
            return fault("has pixels in the format " + quotedName(line.substr(7)) +
                             ". Export it with RGB colours, 32-bit_rle_rgbe.",
                         ErrorCode::Unsupported);
        }
        m_hasFormat = true;
    }
    const auto wrong = [&] {
        return fault("has " + quotedName(line) + " in its header, whose numbers must be from 1e-9 to 1e9.");
    };
    if (line.starts_with("EXPOSURE=")) {
        const auto exposure = factorsOf<1>(line.substr(9));
        if (!exposure) return wrong();
        for (double& factor : m_factors) factor *= (*exposure)[0];
    }
    if (line.starts_with("COLORCORR=")) {
        const auto correction = factorsOf<3>(line.substr(10));
        if (!correction) return wrong();
        for (std::size_t k = 0; k < 3; ++k) m_factors[k] *= (*correction)[k];
    }
    if (std::ranges::any_of(m_factors, [](double f) { return f < 1.0 / kMaxFactor || f > kMaxFactor; })) return wrong();
    return success();
}

Status RadianceReader::checkSize() const {
    const std::uint32_t width = m_order.width(), height = m_order.height();
    const std::string size = std::to_string(width) + " × " + std::to_string(height) + " pixels";
    if (width > kMaxSkyFileWidth || height > kMaxSkyFileWidth / 2) {
        return fault("is too large: " + size + ". Scale it down to at most " + std::to_string(kMaxSkyFileWidth) +
                         " × " + std::to_string(kMaxSkyFileWidth / 2) + ".",
                     ErrorCode::Limit);
    }
    if (width == 2 * height) return success();
    return fault(
        "has " + size + ", but a whole sky is twice as wide as high. Export it as an equirectangular panorama.",
        ErrorCode::Unsupported);
}

Status RadianceReader::readLine() {
    const bool isEncoded = m_order.length >= kMinEncodedLength && m_rest.size() >= 4 && m_rest[0] == 2 &&
                           m_rest[1] == 2 && static_cast<std::uint8_t>(m_rest[2]) < 128;
    return isEncoded ? readEncodedLine() : readPlainLine();
}

/// The newer encoding: the components one after another, each in runs of one value and of different ones.
Status RadianceReader::readEncodedLine() {
    const auto length =
        static_cast<std::uint32_t>(static_cast<std::uint8_t>(m_rest[2]) << 8 | static_cast<std::uint8_t>(m_rest[3]));
    if (length != m_order.length) {
        return lineFault("has " + std::to_string(length) + " pixels in place of " + std::to_string(m_order.length));
    }
    m_rest.remove_prefix(4);
    for (std::size_t component = 0; component < 4; ++component) {
        for (std::size_t at = 0; at < m_line.size();) {
            if (m_rest.size() < 2) return tooEarly();
            const auto code = static_cast<std::uint8_t>(m_rest[0]);
            const bool isRun = code > 128;
            const std::size_t count = isRun ? code - 128u : code, taken = isRun ? 1 : count;
            if (count == 0) return lineFault("has an empty run");
            if (count > m_line.size() - at) return lineFault("has a run that is too long");
            if (m_rest.size() < 1 + taken) return tooEarly();
            for (std::size_t k = 0; k < count; ++k)
                m_line[at + k][component] = static_cast<std::uint8_t>(m_rest[isRun ? 1 : 1 + k]);
            at += count;
            m_rest.remove_prefix(1 + taken);
        }
    }
    return success();
}

/// Pixels one after another; in the older encoding, one with the colour (1, 1, 1) repeats that before it, and its
/// exponent is the next eight bits of how often.
Status RadianceReader::readPlainLine() {
    unsigned shift = 0;
    for (std::size_t at = 0; at < m_line.size();) {
        if (m_rest.size() < 4) return tooEarly();
        Pixel pixel;
        for (std::size_t k = 0; k < 4; ++k) pixel[k] = static_cast<std::uint8_t>(m_rest[k]);
        m_rest.remove_prefix(4);
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            m_line[at++] = pixel;
            shift = 0;
            continue;
        }
        if (at == 0) return lineFault("repeats a pixel before the first one");
        if (shift > kMaxShift) return lineFault("has a run that is too long");
        const std::size_t count = std::size_t{pixel[3]} << shift;
        if (count > m_line.size() - at) return lineFault("has a run that is too long");
        std::fill_n(m_line.begin() + static_cast<std::ptrdiff_t>(at), count, m_line[at - 1]);
        at += count;
        shift += 8;
    }
    return success();
}

Status RadianceReader::addLine(Reduction& reduction) const {
    for (std::uint32_t k = 0; k < m_order.length; ++k) {
        const Pixel& pixel = m_line[k];
        std::array<double, 3> radiance{};
        for (std::size_t c = 0; c < 3; ++c) radiance[c] = (pixel[c] + 0.5) * m_scales[pixel[3]] / m_factors[c];
        if (std::max({radiance[0], radiance[1], radiance[2]}) > kMaxRadiance)
            return lineFault("has a pixel brighter than 1e30");
        const std::uint32_t x = m_order.isByColumn ? m_lineNumber : k, y = m_order.isByColumn ? k : m_lineNumber;
        reduction.add(m_order.isRightToLeft ? m_order.width() - 1 - x : x,
                      m_order.isBottomUp ? m_order.height() - 1 - y : y, radiance);
    }
    return success();
}

}  // namespace

Result<RadianceImage> radianceOfFile(std::string_view bytes, const std::string& name, const TaskContext& task) {
    return RadianceReader(bytes, name).read(task);
}

Result<RadianceImage> loadRadiance(const std::filesystem::path& path, const TaskContext& task) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.error();
    return radianceOfFile(*bytes, path.filename().string(), task);
}

}  // namespace rubble
