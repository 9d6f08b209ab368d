#pragma once

#include "tests/attack/monkey/Journal.h"

#include <QObject>

#include <functional>

namespace rubble::attack {

/// Restores every backup that the program offers when it starts, as a user does. Fails at any other dialog.
class BackupAnswers : public QObject {
public:
    /// Calls `restored` when the last offer is answered.
    BackupAnswers(JournalWriter& journal, std::function<void()> restored);

    /// To be called after the program's start(), which posts the offers.
    void expectOffers();

private:
    void answer();

    JournalWriter& m_journal;
    std::function<void()> m_restored;
    bool m_areOffersPosted = false;
};

/// Ends the program as a user does who wants to keep nothing: closes popups, dialogs and windows, and discards changes.
class Closing : public QObject {
public:
    void begin();

private:
    void closeNext();
};

}  // namespace rubble::attack
