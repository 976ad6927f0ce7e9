// Names of the codes that the control's own rules speak of. What a code is stands in its row of the tables.
#pragma once

#include <cstdint>

namespace proveout::nc {

/// G codes, the number tenfold: 541 is G54.1.
namespace gcode {

inline constexpr std::int32_t kRapid = 0, kLine = 10, kArcClockwise = 20, kArcCounterClockwise = 30;
inline constexpr std::int32_t kThread = 330;
inline constexpr std::int32_t kExactStop = 90, kExactStopMode = 610, kSlowInsideCorners = 620,
                              kNoOverride = 630, kContinuousCutting = 640;
inline constexpr std::int32_t kPolarOff = 131, kCylinder = 71;  // planes with a rotary axis
inline constexpr std::int32_t kDiameter = 109;
inline constexpr std::int32_t kPolarDataOff = 150, kPolarData = 160;
inline constexpr std::int32_t kPlaneXY = 170, kPlaneZX = 180, kPlaneYZ = 190;
inline constexpr std::int32_t kInch = 200, kMetric = 210;
inline constexpr std::int32_t kZoneOff = 230;
inline constexpr std::int32_t kReference = 280, kNumberedReference = 300;
inline constexpr std::int32_t kSkip = 310, kMeasureLength = 370;
inline constexpr std::int32_t kKeepVector = 380, kCornerArc = 390;  // of cutter compensation
inline constexpr std::int32_t kCompOff = 400, kCompLeft = 410, kCompRight = 420;
inline constexpr std::int32_t kCompInSpace = 1410;  // along a vector of the block, in the same group
inline constexpr std::int32_t kLengthPlus = 430, kLengthTurning = 437, kLengthMinus = 440, kLengthOff = 490;
inline constexpr std::int32_t kLengthAlongTool = 431, kToolDirection = 531, kDynamicZero = 542;  // five axes
inline constexpr std::int32_t kTipByAngles = 434, kTipByVector = 435, kToolDirectionAboutTip = 536;
inline constexpr std::int32_t kSpaceRotation = 681, kTiltedPlane = 682;
inline constexpr std::int32_t kScalingOff = 500, kMirrorOff = 501, kMirror = 511;
inline constexpr std::int32_t kLocalShift = 520, kMachineMove = 530, kSetPosition = 920;
inline constexpr std::int32_t kWorkSystem1 = 540, kExtendedWorkSystem = 541;
inline constexpr std::int32_t kMacroCall = 650, kMacroAfterMotions = 660, kMacroOfBlocks = 661,
                              kMacroCancel = 670;
inline constexpr std::int32_t kRotationOff = 690, kTiltOff = 691;
inline constexpr std::int32_t kChipBreak = 730, kTapLeft = 740, kFineBore = 760;  // milling coding
inline constexpr std::int32_t kChipBreakBesideTurning = 831, kTapLeftBesideTurning = 841,
                              kFineBoreBesideTurning = 861;
inline constexpr std::int32_t kRigidTap = 842, kRigidTapLeft = 843, kCycleCancel = 800, kGearOff = 808;
inline constexpr std::int32_t kAbsolute = 900, kIncremental = 910;
inline constexpr std::int32_t kInverseTime = 930, kFeedPerMinute = 940, kFeedPerTurn = 950;
inline constexpr std::int32_t kSurfaceSpeed = 960, kSurfaceSpeedOff = 970;
inline constexpr std::int32_t kReturnToInitial = 980, kReturnToR = 990;

}  // namespace gcode

namespace mcode {

inline constexpr std::int32_t kStop = 0, kOptionalStop = 1, kEnd = 2, kEndAndRewind = 30;
inline constexpr std::int32_t kClockwise = 3, kCounterClockwise = 4, kSpindleStop = 5, kOrient = 19;
inline constexpr std::int32_t kToolChange = 6;
inline constexpr std::int32_t kSecondCoolantOn = 7, kCoolantOn = 8, kCoolantOff = 9;
inline constexpr std::int32_t kFirstRange = 11, kLastRange = 18;  // of the spindle
inline constexpr std::int32_t kInterruptOn = 96, kInterruptOff = 97;
inline constexpr std::int32_t kCall = 98, kReturn = 99;

/// Does the spindle turn behind it?
constexpr bool turns(std::int32_t m) { return m == kClockwise || m == kCounterClockwise; }

}  // namespace mcode

}  // namespace proveout::nc
