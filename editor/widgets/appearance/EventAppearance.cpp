#include "editor/widgets/appearance/EventAppearance.h"

#include <QCoreApplication>

namespace rubble {

namespace {

struct EventTexts {
    Q_DECLARE_TR_FUNCTIONS(rubble::EventAppearance)
};

}  // namespace

QString titleOf(EventKind kind) {
    switch (kind) {
        case EventKind::Impact: return EventTexts::tr("Impact");
        case EventKind::Bonds: return EventTexts::tr("Broken bonds");
        case EventKind::Detached: return EventTexts::tr("Detached");
        case EventKind::Broken: return EventTexts::tr("Break");
        case EventKind::Settled: return EventTexts::tr("Settled");
        case EventKind::Removed: return EventTexts::tr("Removed");
    }
    return {};
}

QString pluralOf(EventKind kind) {
    switch (kind) {
        case EventKind::Impact: return EventTexts::tr("Impacts");
        case EventKind::Bonds: return EventTexts::tr("Broken Bonds");
        case EventKind::Detached: return EventTexts::tr("Detached Islands");
        case EventKind::Broken: return EventTexts::tr("Breaks");
        case EventKind::Settled: return EventTexts::tr("Settled Bodies");
        case EventKind::Removed: return EventTexts::tr("Removed Bodies");
    }
    return {};
}

QString iconNameOf(EventKind kind) {
    switch (kind) {
        case EventKind::Impact: return QStringLiteral("event-impact");
        case EventKind::Bonds: return QStringLiteral("event-bonds");
        case EventKind::Detached: return QStringLiteral("event-detached");
        case EventKind::Broken: return QStringLiteral("event-broken");
        case EventKind::Settled: return QStringLiteral("event-settled");
        case EventKind::Removed: return QStringLiteral("event-removed");
    }
    return {};
}

QColor colourOf(EventKind kind) {
    switch (kind) {
        case EventKind::Impact: return {217, 119, 6};
        case EventKind::Bonds: return {8, 145, 178};
        case EventKind::Detached: return {59, 130, 246};
        case EventKind::Broken: return {214, 69, 48};
        case EventKind::Settled: return {22, 163, 74};
        case EventKind::Removed: return {139, 92, 246};
    }
    return {};
}

std::array<EventKind, kEventKinds> eventKinds() {
    return {EventKind::Impact, EventKind::Bonds,   EventKind::Detached,
            EventKind::Broken, EventKind::Settled, EventKind::Removed};
}

}  // namespace rubble
