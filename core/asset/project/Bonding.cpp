#include "core/asset/project/Bonding.h"

namespace rubble {

bool StrengthImage::operator==(const StrengthImage& other) const {
    const bool isSame = image == other.image || (image && other.image && *image == *other.image);
    return isSame && darkest == other.darkest && brightest == other.brightest;
}

}  // namespace rubble
