// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the values of choices in session files and preferences, mostly those of the command
// line.
#pragma once

#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/document/alpha/alpha_slider.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/reference/atom_labels.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "core/read/file_format.hpp"

namespace alphascope {

// Is the type one of those below?
template <class Type>
concept IsChoice = std::is_enum_v<Type> || std::is_same_v<Type, const FileFormat*>;

template <class Choice>
using SettingIds = std::vector<std::pair<Choice, std::string_view>>;

// The argument only selects the overload. Every value of the type has one word.
const SettingIds<AltlocRule>& setting_ids(AltlocRule);
const SettingIds<HydrogenRule>& setting_ids(HydrogenRule);
const SettingIds<RadiiSet>& setting_ids(RadiiSet);
const SettingIds<const FileFormat*>& setting_ids(const FileFormat*);
const SettingIds<EngineChoice>& setting_ids(EngineChoice);
const SettingIds<TupleGridKind>& setting_ids(TupleGridKind);
const SettingIds<AlphaScaling>& setting_ids(AlphaScaling);
const SettingIds<LabelText>& setting_ids(LabelText);
const SettingIds<RecordingKind>& setting_ids(RecordingKind);
const SettingIds<TurnAxis>& setting_ids(TurnAxis);
const SettingIds<ObjectKind>& setting_ids(ObjectKind);
const SettingIds<ObjectColour>& setting_ids(ObjectColour);

}  // namespace alphascope
