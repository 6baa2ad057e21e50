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
class Requests;

/// The chain doctor: compares the modules expected with those found, and says where the chain probably
/// breaks.
class DoctorPage : public QWidget {
    Q_OBJECT

public:
    explicit DoctorPage(Requests& requests, QWidget* parent = nullptr);

    /// `whyNoRestart`: why the network cannot be restarted. `whyNotEdited`: why the expected chain cannot be
    /// changed. Emits nothing.
    void showChain(const ChainDiagnosis& chain, std::optional<Refusal> whyNoRestart,
                   std::optional<Refusal> whyNotEdited);

private:
    enum Column { Module, Name, Expected, Found, Verdict, Columns };

    void build(const Requests& requests);
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
