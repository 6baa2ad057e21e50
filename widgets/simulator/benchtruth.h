// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QJsonObject>
#include <QWidget>

class QGridLayout;
class QLabel;

namespace nmc {

class GlyphLabel;

/// What only a simulator knows: the true position of the shaft, what drives it, and how often it received
/// something that would have upset a real module.
class BenchTruth : public QWidget {
    Q_OBJECT

public:
    explicit BenchTruth(QWidget* parent = nullptr);

    /// Shows the answer to `state N`.
    void showState(const QJsonObject& state);
    /// Shows the answer to `stats`.
    void showStatistics(const QJsonObject& statistics);
    void forget();

private:
    struct Row {
        QLabel* label = nullptr;
        QLabel* value = nullptr;
        QLabel* unit = nullptr;
        int significant = 0;  ///< 0: a whole number
    };

    void addRow(QGridLayout& grid, const QString& key, const QString& label, const QString& unit,
                int significant, const QString& meaning);

    QHash<QString, Row> m_rows;
    GlyphLabel* m_violationsSign;
    QLabel* m_violations;
};

}  // namespace nmc
