#include "editor/play/EventText.h"

#include "editor/document/ShownText.h"

#include <QCoreApplication>

namespace rubble {

namespace {

struct EventTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::EventText)
};

QString impactText(const QString& name, const PlayEvent& event) {
    if (event.otherName.empty()) return EventTexts::tr("%1 was hit").arg(name);
    return EventTexts::tr("%1 and %2 hit each other").arg(name, nameText(event.otherName));
}

QString breakText(const QString& name, const PlayEvent& event) {
    const int count = static_cast<int>(event.record.count);
    if (event.otherName.empty()) return EventTexts::tr("%1 broke into %Ln fragment(s)", nullptr, count).arg(name);
    return EventTexts::tr("%1 broke into %Ln fragment(s), hit by %2", nullptr, count)
        .arg(name, nameText(event.otherName));
}

QString removalText(const QString& name, RemovalReason reason) {
    switch (reason) {
        case RemovalReason::None: return EventTexts::tr("%1 was removed").arg(name);
        case RemovalReason::Lifetime: return EventTexts::tr("%1 was removed: its lifetime as debris ended").arg(name);
        case RemovalReason::Budget: return EventTexts::tr("%1 was removed: there was too much debris").arg(name);
        case RemovalReason::LeftWorld: return EventTexts::tr("%1 was removed: it left the world").arg(name);
        case RemovalReason::Input: return EventTexts::tr("%1 was taken away").arg(name);
    }
    return {};
}

}  // namespace

QString sentenceOf(const PlayEvent& event) {
    const QString name = nameText(event.name);
    const int count = static_cast<int>(event.record.count);
    switch (event.record.kind) {
        case EventKind::Impact: return impactText(name, event);
        case EventKind::Bonds: return EventTexts::tr("%Ln bond(s) of %1 broke", nullptr, count).arg(name);
        case EventKind::Detached: return EventTexts::tr("%1 came off").arg(name);
        case EventKind::Broken: return breakText(name, event);
        case EventKind::Settled: return EventTexts::tr("%1 came to rest").arg(name);
        case EventKind::Removed: return removalText(name, event.record.reason);
    }
    return {};
}

QString textOf(const BreakCounts& counts) {
    QStringList texts;
    if (counts.breaks > 0) texts << EventTexts::tr("%Ln break(s)", nullptr, static_cast<int>(counts.breaks));
    if (counts.bonds > 0) texts << EventTexts::tr("%Ln broken bond(s)", nullptr, static_cast<int>(counts.bonds));
    return texts.isEmpty() ? EventTexts::tr("no breaks") : texts.join(QStringLiteral(", "));
}

}  // namespace rubble
