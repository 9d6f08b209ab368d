#include "editor/widgets/ComboBox.h"

#include "editor/widgets/ColourButton.h"
#include "editor/widgets/ColourConversion.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr int kColourRole = Qt::UserRole + 1;
constexpr int kMinCharacters = 8;  // that fit into a box

QString colourName(const ComboItem& item) { return item.colour ? toQColor(*item.colour).name() : QString(); }

bool isEqual(const QComboBox& box, int row, const ComboItem& item) {
    return box.itemData(row).toUInt() == item.id && box.itemText(row) == item.text &&
           box.itemData(row, kColourRole).toString() == colourName(item);
}

}  // namespace

QComboBox* comboBox(const QStringList& texts, const QString& toolTip) {
    auto* box = new QComboBox;
    box->addItems(texts);
    box->setToolTip(toolTip);
    return box;
}

void restoreIndex(QComboBox& box, int index) { box.setCurrentIndex(std::min(std::max(index, 0), box.count() - 1)); }

void setItems(QComboBox& box, const std::vector<ComboItem>& items) {
    box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // long names do not widen a dock
    box.setMinimumContentsLength(kMinCharacters);
    const int count = static_cast<int>(items.size());
    bool isSame = box.count() == count;
    for (int row = 0; row < count && isSame; ++row) isSame = isEqual(box, row, items[row]);
    if (isSame) return;
    box.clear();
    for (int row = 0; row < count; ++row) {
        const ComboItem& item = items[row];
        box.addItem(item.colour ? swatchIcon(*item.colour) : QIcon(), item.text, item.id);
        box.setItemData(row, colourName(item), kColourRole);
    }
}

}  // namespace rubble
