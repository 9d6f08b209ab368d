#include "editor/dialogs/ContactSheetText.h"

#include "editor/widgets/LocalizedQuantity.h"

#include <QCoreApplication>
#include <QLocale>

namespace rubble {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ContactSheet", text); }

QString shotText(const SheetFigures& figures) {
    if (!figures.breakImpact) return tr("did not break");
    const QString broke = tr("broke at %1").arg(localizedQuantity(QuantityKind::Impulse, *figures.breakImpact));
    if (!figures.debrisHeight) return broke;
    return tr("%1, up to %2").arg(broke, localizedQuantity(QuantityKind::Length, *figures.debrisHeight));
}

}  // namespace

QString measureName(SheetMeasure measure) {
    switch (measure) {
        case SheetMeasure::Number: return tr("Number");
        case SheetMeasure::Pieces: return tr("Fragments");
        case SheetMeasure::SmallestPiece: return tr("Smallest fragment");
        case SheetMeasure::Aspect: return tr("Longest fragment");
        case SheetMeasure::BreakImpact: return tr("Breaking impact");
        case SheetMeasure::DebrisHeight: return tr("Debris height");
    }
    return {};
}

QString captionOf(const SheetEntry& entry) {
    const QString name = entry.number == 0 ? tr("Current") : tr("No. %1").arg(entry.number);
    if (entry.fault) return name + '\n' + QString::fromStdString(*entry.fault);
    const SheetFigures& figures = entry.figures;
    const int count = static_cast<int>(figures.pieces);
    QString text = name + " · " + QCoreApplication::translate("ContactSheet", "%Ln fragment(s)", nullptr, count) +
                   '\n' +
                   tr("smallest %1, longest %2 : 1")
                       .arg(localizedQuantity(QuantityKind::Volume, figures.smallestPiece),
                            QLocale().toString(figures.aspect, 'f', 1));
    if (figures.isPlayed) text += '\n' + shotText(figures);
    return text;
}

}  // namespace rubble
