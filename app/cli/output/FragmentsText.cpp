#include "app/cli/output/FragmentsText.h"

#include "core/base/QuantityText.h"

namespace rubble {

std::string fragmentsText(std::size_t count, double volume) {
    return countText(count, "fragment", "fragments") + ", " + quantityText(QuantityKind::Volume, volume);
}

}  // namespace rubble
