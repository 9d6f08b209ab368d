#include "core/io/project/GreyImageJson.h"

namespace rubble {
namespace {

constexpr std::string_view kGreyDigits = "0123456789abcdef";

std::size_t digitsOf(const GreyImage& image) { return image.bits / 4; }

void writeRows(JsonWriter& json, std::string_view key, const GreyImage& image,
               const std::vector<std::uint16_t>& values) {
    if (values.empty()) return json.null(key);
    json.openArray(key);
    std::string row;
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
        for (std::size_t digit = digitsOf(image); digit-- > 0;)
            row += kGreyDigits[(values[pixel] >> (4 * digit)) & 15u];
        if ((pixel + 1) % image.width != 0) continue;
        json.text({}, row);
        row.clear();
    }
    json.close();
}

/// Appends the values of a row; returns false if it does not have the right number of hexadecimal digits.
bool appendRow(const std::string& row, const GreyImage& image, std::vector<std::uint16_t>& values) {
    const std::size_t digits = digitsOf(image);
    if (row.size() != digits * image.width) return false;
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const std::size_t digit = kGreyDigits.find(row[k]);
        if (digit == std::string_view::npos) return false;
        value = value << 4 | static_cast<std::uint32_t>(digit);
        if ((k + 1) % digits != 0) continue;
        values.push_back(static_cast<std::uint16_t>(value));
        value = 0;
    }
    return true;
}

std::vector<std::uint16_t> readRows(const JsonValue& value, const GreyImage& image) {
    std::vector<std::uint16_t> values;
    for (const JsonValue row : value.elements()) {
        if (!appendRow(row.text(), image, values)) {
            row.fail("expected " + std::to_string(digitsOf(image) * image.width) + " hexadecimal digits, 0 to f");
            return {};
        }
    }
    if (values.size() != std::size_t{image.width} * image.height) {
        value.fail("expected " + std::to_string(image.height) + " rows");
    }
    return values;
}

}  // namespace

void writeGreyImage(JsonWriter& json, std::string_view key, const GreyImage* image) {
    if (!image) return json.null(key);
    json.openObject(key);
    json.wholeNumber("width", image->width);
    json.wholeNumber("height", image->height);
    json.wholeNumber("bits", image->bits);
    writeRows(json, "grey", *image, image->grey);
    writeRows(json, "opacity", *image, image->opacity);
    json.close();
}

std::shared_ptr<const GreyImage> readGreyImage(const JsonValue& value) {
    if (value.isNull()) return nullptr;
    value.requireObject({"width", "height", "bits", "grey", "opacity"});
    auto image = std::make_shared<GreyImage>();
    image->width = value["width"].index(1, GreyImage::kMaxSide);
    image->height = value["height"].index(1, GreyImage::kMaxSide);
    image->bits = value["bits"].index(8, 16);
    if (image->bits != 8 && image->bits != 16) value["bits"].fail("expected 8 or 16");
    image->grey = readRows(value["grey"], *image);
    if (!value["opacity"].isNull()) image->opacity = readRows(value["opacity"], *image);
    return image;
}

}  // namespace rubble
