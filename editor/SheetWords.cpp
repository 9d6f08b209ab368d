#include "editor/SheetWords.h"

#include "editor/canvas/LabelPainting.h"

#include <QCoreApplication>
#include <QLocale>

namespace rubble {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("ContactSheet", text); }

QString shotText(const SheetFigures& figures) {
    if (!figures.breakImpact) return tr("did not break");
    const QString broke = tr("broke at %1").arg(impulseText(*figures.breakImpact));
    return figures.debrisHeight ? tr("%1, up to %2").arg(broke, lengthText(*figures.debrisHeight)) : broke;
}

}  // namespace

QString nameText(SheetMeasure measure) {
    switch (measure) {
        case SheetMeasure::Number: return tr("As they were made");
        case SheetMeasure::Pieces: return tr("Pieces");
        case SheetMeasure::SmallestPiece: return tr("Smallest piece");
        case SheetMeasure::Aspect: return tr("Longest piece, length : width");
        case SheetMeasure::BreakImpact: return tr("Impact to break");
        case SheetMeasure::DebrisHeight: return tr("Height of debris");
    }
    return {};
}

QString labelText(const SheetEntry& entry) {
    const QString name = entry.number == 0 ? tr("As it is") : tr("No. %1").arg(entry.number);
    if (entry.fault) return name + '\n' + QString::fromStdString(*entry.fault);
    const SheetFigures& figures = entry.figures;
    QString text = tr("%1 · %L2 pieces").arg(name).arg(figures.pieces) + '\n' +
                   tr("smallest %1, longest %2 : 1")
                       .arg(volumeText(figures.smallestPiece), QLocale().toString(figures.aspect, 'f', 1));
    if (figures.isPlayed) text += '\n' + shotText(figures);
    return text;
}

}  // namespace rubble
