#pragma once

#include "editor/document/Document.h"
#include "editor/panels/Controls.h"

#include <QToolTip>

#include <algorithm>
#include <vector>

namespace rubble {

/// Controls that show members of the values that are chosen, and write them: each reads one member of a value, and where it
/// is edited, writes it in all of them as one step. Several values that differ are shown as such.
template <class Value>
class Form {
public:
    using Values = std::vector<Value>;
    /// Copies of what is chosen; none where nothing is.
    using Chosen = std::function<Values()>;
    /// Puts other values in place of the chosen ones.
    using Push = std::function<void(Values values, const QString& text, quint64 stroke)>;
    /// What is wrong with a value, as a sentence; empty where it may be taken.
    using Fault = std::function<QString(const Value&)>;

    Form(Document& document, Chosen chosen, Push push)
        : m_document(document), m_chosen(std::move(chosen)), m_push(std::move(push)) {}

    void setFault(Fault fault) { m_fault = std::move(fault); }
    /// Who is told what was refused.
    void setRefused(std::function<void(const QString&)> refused) { m_refused = std::move(refused); }

    /// `text` is what the step is called.
    template <class Control, class Read, class Write>
    void bind(Control* control, const QString& text, Read read, Write write) {
        m_shows.push_back([control, read](const Values& values) {
            const auto first = read(values.front());
            const bool isCommon = std::ranges::all_of(values, [&](const Value& value) { return read(value) == first; });
            isCommon ? showIn(*control, first) : showMixedIn(*control);
        });
        connectTo(
            *control, [this] { m_stroke = m_document.newStroke(); },
            [this, control, text, write](const auto& entered) {
                Values values = m_chosen();
                for (Value& value : values) write(value, entered);
                enter(std::move(values), text, *control);
            });
    }
    /// The same for a member that is read and written as it is.
    template <class Control, class Member>
    void bind(Control* control, const QString& text, Member Value::*member) {
        bind(
            control, text, [member](const Value& value) { return value.*member; },
            [member](Value& value, const Member& entered) { value.*member = entered; });
    }

    /// Shows the chosen values as they are now.
    void refresh() const {
        const Values values = m_chosen();
        if (values.empty()) return;
        for (const auto& show : m_shows) show(values);
    }

private:
    void enter(Values values, const QString& text, QWidget& control) {
        for (const Value& value : values) {
            const QString fault = m_fault ? m_fault(value) : QString();
            if (fault.isEmpty()) continue;
            refresh();
            QToolTip::showText(control.mapToGlobal(QPoint(0, control.height())), fault, &control);
            if (m_refused) m_refused(fault);
            return;
        }
        m_push(std::move(values), text, m_stroke);
    }

    Document& m_document;
    Chosen m_chosen;
    Push m_push;
    Fault m_fault;
    std::function<void(const QString&)> m_refused;
    std::vector<std::function<void(const Values&)>> m_shows;
    quint64 m_stroke = 0;
};

/// A push for things that are swapped by their ids.
template <class Value>
typename Form<Value>::Push pushOf(Document& document) {
    return [&document](std::vector<Value> values, const QString& text, quint64 stroke) {
        Edit edit{.text = text, .stroke = stroke};
        for (Value& value : values) {
            const Id id = value.id;
            edit.swaps.push_back(Swap<Value>{id, std::move(value)});
        }
        document.push(std::move(edit));
    };
}

}  // namespace rubble
