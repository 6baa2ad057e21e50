// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "model/intent/intent.h"
#include "model/module/chaindiagnosis.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace nmc {

class GlyphLabel;

/// The chain doctor: expected against found, and where the chain probably breaks, in words.
class DoctorPage : public QWidget {
    Q_OBJECT

public:
    explicit DoctorPage(QWidget* parent = nullptr);

    /// `whyNoRestart`: the network cannot be restarted; `whyNotEdited`: nor what is expected changed. Emits
    /// nothing.
    void showChain(const ChainDiagnosis& chain, std::optional<Refusal> whyNoRestart,
                   std::optional<Refusal> whyNotEdited);

signals:
    /// Looks for the chain again; nothing is reset.
    void scanRequested();
    void restartRequested();
    /// What is there now is what is expected from now on.
    void acceptRequested();

private:
    enum Column { Address, Name, Expected, Found, Verdict, Columns };

    void build();
    void fill();

    GlyphLabel* m_glyph = nullptr;
    QLabel* m_finding = nullptr;
    QLabel* m_advice = nullptr;
    QTableWidget* m_table = nullptr;
    QPushButton* m_scan = nullptr;
    QPushButton* m_accept = nullptr;
    QPushButton* m_restart = nullptr;
    std::optional<ChainDiagnosis> m_chain;
    std::optional<Refusal> m_whyNoRestart;
    std::optional<Refusal> m_whyNotEdited;
};

}  // namespace nmc
