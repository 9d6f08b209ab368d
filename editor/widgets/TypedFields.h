#pragma once

class QWidget;

namespace rubble {

/// Applies the typed texts of all fields with numbers in a dialog. Returns false if one is refused, which then has the
/// focus.
bool commitFields(const QWidget& dialog);

/// Shows the values in place of texts that were typed, as when a panel shows another subject.
void discardTyping(const QWidget& panel);

}  // namespace rubble
