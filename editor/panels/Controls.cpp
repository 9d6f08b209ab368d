#include "editor/panels/Controls.h"

namespace rubble {

namespace {

constexpr int kColourRole = Qt::UserRole + 1;

QString colourName(const Choice& choice) { return choice.colour ? toQColor(*choice.colour).name() : QString(); }

constexpr int kLeastLetters = 8;  // that a box has room for

bool isOffered(const QComboBox& box, int row, const Choice& choice) {
    return box.itemData(row).toUInt() == choice.id && box.itemText(row) == choice.text &&
           box.itemData(row, kColourRole).toString() == colourName(choice);
}

}  // namespace

void offer(QComboBox& box, const std::vector<Choice>& choices) {
    box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // long names do not widen a dock
    box.setMinimumContentsLength(kLeastLetters);
    const int count = static_cast<int>(choices.size());
    bool isSame = box.count() == count;
    for (int row = 0; row < count && isSame; ++row) isSame = isOffered(box, row, choices[row]);
    if (isSame) return;
    box.clear();
    for (int row = 0; row < count; ++row) {
        const Choice& choice = choices[row];
        box.addItem(choice.colour ? swatchIcon(*choice.colour) : QIcon(), choice.text, choice.id);
        box.setItemData(row, colourName(choice), kColourRole);
    }
}

}  // namespace rubble
