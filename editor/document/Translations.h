#pragma once

namespace rubble {

/// Installs the translation of the user interface into the application. Texts in the code are English; their
/// translation holds the plural forms of texts with counts.
void installTranslations();

}  // namespace rubble
