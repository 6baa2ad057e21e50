// SPDX-License-Identifier: MIT
#include "model/tuning/motormodel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace nmc {

MotorConstants MotorModel::constants() const {
    return {gain.value,  timeConstant.value, friction.value, load.value,
            delay.value, deadband.value,     play.value,     noise};
}

bool MotorModel::isSure() const {
    constexpr double kPart = 0.15;
    return gain.doubt <= kPart * gain.value && friction.doubt <= std::max(1.0, kPart * friction.value);
}

std::vector<MotorConstants> MotorModel::drawn(std::size_t count) const {
    using Square = Eigen::Matrix<double, kConstants, kConstants, Eigen::RowMajor>;
    using Column = Eigen::Matrix<double, kConstants, 1>;
    const Eigen::Map<const Square> matrix(correlation.front().data());
    // A square root instead of a Cholesky factor, because fully correlated doubts give an eigenvalue of 0.
    const Eigen::SelfAdjointEigenSolver<Square> solver(matrix);
    const Square root = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<MotorConstants> motors;
    for (std::size_t i = 0; i < count; ++i) {
        const Column off = root * Column::NullaryExpr([&] { return normal(random); });
        const auto times = [](const Measured& measured, double by) {
            return measured.value * std::exp(by * measured.doubt / measured.value);
        };
        motors.push_back({times(gain, off[0]), times(timeConstant, off[1]),
                          std::abs(friction.value + off[2] * friction.doubt),
                          load.value + off[3] * load.doubt, std::abs(delay.value + off[4] * delay.doubt),
                          std::abs(deadband.value + off[5] * deadband.doubt),
                          std::abs(play.value + off[6] * play.doubt), noise});
    }
    return motors;
}

}  // namespace nmc
