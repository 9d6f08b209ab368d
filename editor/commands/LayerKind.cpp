#include "editor/commands/LayerKind.h"

#include <QCoreApplication>

namespace rubble {

QString kindText(const LayerParameters& parameters) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("LayerKind", text); };
    switch (parameters.index()) {
        case 0: return tr("Uniform");
        case 1: return tr("Blue noise");
        case 2: return tr("Placed seeds");
        default: return tr("Lloyd relaxation");
    }
}

}  // namespace rubble
