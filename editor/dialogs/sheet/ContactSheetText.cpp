#include "editor/dialogs/sheet/ContactSheetText.h"

#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>
#include <QLocale>

namespace rubble {

namespace {

struct ContactSheetTexts {
    Q_DECLARE_TR_FUNCTIONS(ContactSheet)
};

QString shotText(const SheetFigures& figures, const Units& units) {
    if (!figures.breakImpact) return ContactSheetTexts::tr("did not break");
    const QString impact = localizedQuantity(QuantityKind::Impulse, *figures.breakImpact);
    if (!figures.debrisHeight) return ContactSheetTexts::tr("broke at %1").arg(impact);
    return ContactSheetTexts::tr("broke at %1, debris up to %2 high")
        .arg(impact, localizedQuantity(QuantityKind::Length, *figures.debrisHeight, units));
}

}  // namespace

QString measureName(SheetMeasure measure) {
    switch (measure) {
        case SheetMeasure::Number: return ContactSheetTexts::tr("Number");
        case SheetMeasure::Fragments: return ContactSheetTexts::tr("Fragments");
        case SheetMeasure::SmallestFragment: return ContactSheetTexts::tr("Smallest fragment");
        case SheetMeasure::Aspect: return ContactSheetTexts::tr("Longest fragment");
        case SheetMeasure::BreakImpact: return ContactSheetTexts::tr("Breaking impact");
        case SheetMeasure::DebrisHeight: return ContactSheetTexts::tr("Debris height");
    }
    return {};
}

QString captionOf(const SheetEntry& entry, const Units& units) {
    const QString name =
        entry.number == 0 ? ContactSheetTexts::tr("Current") : ContactSheetTexts::tr("No. %1").arg(entry.number);
    if (entry.fault) return name + '\n' + QString::fromStdString(*entry.fault);
    const SheetFigures& figures = entry.figures;
    const int count = static_cast<int>(figures.fragments);
    QString text = name + " · " + ContactSheetTexts::tr("%Ln fragment(s)", nullptr, count) + '\n' +
                   ContactSheetTexts::tr("smallest %1, longest %2 : 1")
                       .arg(localizedQuantity(QuantityKind::Volume, figures.smallestFragment, units),
                            QLocale().toString(figures.aspect, 'f', 1));
    if (figures.isPlayed) text += '\n' + shotText(figures, units);
    return text;
}

QString fragmentChanges(const Asset& asset) {
    QStringList lines;
    const auto edits = static_cast<int>(asset.edits.size()), leaves = static_cast<int>(asset.fragmentLevels.size()),
               thresholds = static_cast<int>(asset.fragmentThresholds.size()),
               unbreakable = static_cast<int>(asset.bonding.neverBreaks.size()),
               clusters = static_cast<int>(asset.bonding.clusters.size());
    if (edits > 0) lines += ContactSheetTexts::tr("%Ln merge(s) or split(s)", nullptr, edits);
    if (leaves > 0) lines += ContactSheetTexts::tr("%Ln pattern(s) of single fragments", nullptr, leaves);
    if (thresholds > 0) lines += ContactSheetTexts::tr("%Ln threshold(s) of single fragments", nullptr, thresholds);
    if (unbreakable > 0) lines += ContactSheetTexts::tr("%Ln fragment(s) that never break", nullptr, unbreakable);
    if (clusters > 0) lines += ContactSheetTexts::tr("%Ln cluster(s) of fragments", nullptr, clusters);
    lines += QString();
    lines += ContactSheetTexts::tr(
        "The variant has fragments of the same names in other places. What does not fit them is "
        "reported in Messages.");
    return lines.join('\n');
}

}  // namespace rubble
