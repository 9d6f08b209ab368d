#pragma once

#include "core/asset/Bake.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace rubble {

enum class Severity { Note, Warning, Fault };

/// Something the user should know, and where it is.
struct Message {
    Severity severity = Severity::Note;
    QString text;  // one sentence
    Id asset = 0;  // 0: none
    std::optional<SeedId> seed;
    std::vector<Id> instances;  // that it is about
    QDateTime time = QDateTime::currentDateTime();

    /// There is something to show it by.
    bool hasPlace() const { return asset != 0 || !instances.empty(); }
};

/// What was told about a document in one window: the reports of every asset's last bake, what is wrong in the scene, and what
/// imports and exports had to say, in the order it was told.
class Messages : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const std::vector<Message>& list() const { return m_list; }
    void add(Message message);
    /// Takes the place of what was told of this asset's bake before.
    void setOfBake(Id asset, std::vector<Message> messages);
    /// Takes the place of what was told of the scene before.
    void setOfScene(std::vector<Message> messages);
    void clear();

signals:
    void changed();

private:
    void replace(Id topic, std::vector<Message> messages);

    std::vector<Message> m_list;
    std::vector<Id> m_topics;  // of which asset's bake each message is, or of kSceneTopic; 0: it stays
};

/// The reports of a bake as messages.
std::vector<Message> messagesOf(const Bake& bake);

}  // namespace rubble
