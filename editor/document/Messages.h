#pragma once

#include "core/asset/bake/Bake.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace rubble {

/// A message to the user and what it is about.
struct Message {
    Severity severity = Severity::Note;
    QString text;  // one sentence
    Id asset = 0;  // 0: none
    std::optional<SeedId> seed;
    std::vector<Id> instances;  // it is about
    QDateTime time = QDateTime::currentDateTime();

    /// Whether there is something to select or frame for it.
    bool hasPlace() const { return asset != 0 || !instances.empty(); }
};

/// The messages about a document in one window, oldest first: those of every asset's last bake, of the scene, and of
/// imports and exports.
class Messages : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const std::vector<Message>& list() const { return m_list; }
    void add(Message message);
    /// Replaces the messages of this asset's last bake.
    void setOfBake(Id asset, std::vector<Message> messages);
    /// Replaces the messages of the scene, unless they are the same sentences.
    void setOfScene(std::vector<Message> messages);
    void clear();

signals:
    void changed();

private:
    void replace(Id topic, std::vector<Message> messages);

    std::vector<Message> m_list;
    std::vector<Id> m_topics;  // of each message: the asset of its bake or kSceneTopic; 0: none, never replaced
};

/// A sentence about an asset of a project: `"wall": 2 repeated points of the outline were left out.`
QString noteText(const Diagnostic& note, const Project& project);

/// The messages of a bake.
std::vector<Message> messagesOf(const Bake& bake);

}  // namespace rubble
