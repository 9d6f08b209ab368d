#include "editor/widgets/TypedFields.h"

#include "editor/widgets/NumberField.h"
#include "editor/widgets/RandomSeedField.h"

namespace rubble {

namespace {

template <class Field>
bool commitAll(const QWidget& dialog) {
    for (Field* field : dialog.findChildren<Field*>()) {
        if (field->commit()) continue;
        field->setFocus();
        return false;
    }
    return true;
}

}  // namespace

bool commitFields(const QWidget& dialog) {
    return commitAll<NumberField>(dialog) && commitAll<RandomSeedField>(dialog);
}

void discardTyping(const QWidget& panel) {
    for (NumberField* field : panel.findChildren<NumberField*>()) field->discardTyping();
    for (RandomSeedField* field : panel.findChildren<RandomSeedField*>()) field->discardTyping();
}

}  // namespace rubble
