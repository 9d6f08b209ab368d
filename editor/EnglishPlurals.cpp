#include "editor/EnglishPlurals.h"

namespace rubble {

QString EnglishPlurals::translate(const char*, const char* text, const char*, int number) const {
    const QString source = QString::fromUtf8(text);
    if (number < 0 || !source.contains("(s)")) return {};
    return QString(source).replace("(s)", number == 1 ? "" : "s");
}

}  // namespace rubble
