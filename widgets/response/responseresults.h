// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "model/response/responsefile.h"

namespace nmc {

/// What the runs that are drawn come to, A beside B, each with what the samples leave open.
class ResponseResults : public QTableWidget {
    Q_OBJECT

public:
    explicit ResponseResults(QWidget* parent = nullptr);

    /// Either may be null.
    void showRuns(const KeptResponse* a, const KeptResponse* b);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

private:
    void showRun(int column, const KeptResponse* kept);
};

}  // namespace nmc
