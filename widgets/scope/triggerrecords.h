// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "model/scope/scopetrigger.h"
#include "widgets/scope/scoperecord.h"

class QCheckBox;
class QLabel;

namespace nmc {

class NumberField;
class Requests;

/// Saves each picture of the trigger to a folder as a recording, and keeps the last ones: the files are
/// numbered, and the first is replaced after the last. A row of controls for the trigger's bar. GUI thread.
class TriggerRecords : public QWidget {
    Q_OBJECT

public:
    TriggerRecords(Requests& requests, QWidget* parent);

    /// A picture is complete.
    void take(const History& history, const ScopeTrigger::Picture& picture,
              const std::vector<ScopeModule>& modules, const ScopeOrigin& origin);

private:
    void chooseFolder();
    void begin();
    void stop();
    void takeKept();
    void showState();

    Requests& m_requests;
    QCheckBox* m_wanted;
    NumberField* m_keep;
    QLabel* m_state;
    QString m_folder;
    QString m_prefix;           ///< of the files' names; empty while nothing is saved
    std::uint64_t m_taken = 0;  ///< with that prefix
    std::uint64_t m_kept;       ///< the last number that made sense
};

}  // namespace nmc
