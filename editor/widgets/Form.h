#pragma once

#include "editor/document/Document.h"
#include "editor/widgets/FormControls.h"

#include <algorithm>
#include <vector>

namespace rubble {

/// Binds controls to members of the selected values. A control shows one member, or that the values differ; editing it
/// writes that member in all selected values as one undo step.
template <class Value>
class Form {
public:
    using Values = std::vector<Value>;
    /// Returns copies of the selected values; empty if nothing is selected.
    using Selected = std::function<Values()>;
    /// Replaces the selected values.
    using Push = std::function<void(Values values, const QString& text, quint64 mergeKey)>;
    /// Returns what is wrong with a value, as a sentence; empty if it is valid.
    using Fault = std::function<QString(const Value&)>;

    Form(Document& document, Selected selected, Push push)
        : m_document(document), m_selected(std::move(selected)), m_push(std::move(push)) {}

    void setFault(Fault fault) { m_fault = std::move(fault); }
    /// Sets a function that is called with the reason for which a text or an edit is refused.
    void setRefused(std::function<void(const QString&)> refused) { m_refused = std::move(refused); }

    /// `text` names the undo step.
    template <class Control, class Read, class Write>
    void bind(Control* control, const QString& text, Read read, Write write) {
        m_shows.push_back([control, read](const Values& values) {
            const auto first = read(values.front());
            const bool isCommon = std::ranges::all_of(values, [&](const Value& value) { return read(value) == first; });
            isCommon ? showIn(*control, first) : showMixedIn(*control);
        });
        connectRefused(*control, [this](const QString& sentence) {
            if (m_refused) m_refused(sentence);
        });
        connectTo(
            *control, [this] { m_mergeKey = m_document.newMergeKey(); },
            [this, control, text, write](const auto& entered) {
                Values values = m_selected();
                for (Value& value : values) write(value, entered);
                enter(std::move(values), text, *control);
            });
    }
    /// Binds a control to a data member.
    template <class Control, class Member>
    void bind(Control* control, const QString& text, Member Value::*member) {
        bind(
            control, text, [member](const Value& value) { return value.*member; },
            [member](Value& value, const Member& entered) { value.*member = entered; });
    }

    /// Shows the selected values as they are now.
    void refresh() const {
        const Values values = m_selected();
        if (values.empty()) return;
        for (const auto& show : m_shows) show(values);
    }

private:
    template <class Control>
    void enter(Values values, const QString& text, Control& control) {
        for (const Value& value : values) {
            const QString fault = m_fault ? m_fault(value) : QString();
            if (fault.isEmpty()) continue;
            refresh();
            refuseIn(control, fault);
            if (m_refused) m_refused(fault);
            return;
        }
        m_push(std::move(values), text, m_mergeKey);
        refresh();  // the document may have refused the edit
    }

    Document& m_document;
    Selected m_selected;
    Push m_push;
    Fault m_fault;
    std::function<void(const QString&)> m_refused;
    std::vector<std::function<void(const Values&)>> m_shows;
    quint64 m_mergeKey = 0;
};

/// Returns a Push that swaps values by their ids.
template <class Value>
typename Form<Value>::Push pushOf(Document& document) {
    return [&document](std::vector<Value> values, const QString& text, quint64 mergeKey) {
        Edit edit{.text = text, .mergeKey = mergeKey};
        for (Value& value : values) {
            const Id id = value.id;
            edit.replacements.push_back(Replacement<Value>{id, std::move(value)});
        }
        document.push(std::move(edit));
    };
}

}  // namespace rubble
