// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of words for the values of choices in session files and preferences.
#include "core/document/session/setting_ids.hpp"

#include "core/radii/radii_set.hpp"

namespace alphascope {

const SettingIds<AltlocRule>& setting_ids(AltlocRule) {
  static const SettingIds<AltlocRule> ids{{AltlocRule::best, "best"}, {AltlocRule::all, "all"}};
  return ids;
}

const SettingIds<HydrogenRule>& setting_ids(HydrogenRule) {
  static const SettingIds<HydrogenRule> ids{{HydrogenRule::automatic, "auto"},
                                            {HydrogenRule::keep, "keep"},
                                            {HydrogenRule::drop, "drop"}};
  return ids;
}

const SettingIds<RadiiSet>& setting_ids(RadiiSet) {
  static const SettingIds<RadiiSet> ids = [] {
    SettingIds<RadiiSet> all;
    for (const RadiiSetInfo& set : all_radii_sets()) all.emplace_back(set.set, set.id);
    return all;
  }();
  return ids;
}

const SettingIds<const FileFormat*>& setting_ids(const FileFormat*) {
  static const SettingIds<const FileFormat*> ids = [] {
    SettingIds<const FileFormat*> all{{nullptr, "auto"}};
    for (const FileFormat& format : file_formats()) all.emplace_back(&format, format.id);
    return all;
  }();
  return ids;
}

const SettingIds<EngineChoice>& setting_ids(EngineChoice) {
  static const SettingIds<EngineChoice> ids = [] {
    SettingIds<EngineChoice> all;
    for (const EngineEntry& e : engine_table()) all.emplace_back(e.choice, e.id);
    return all;
  }();
  return ids;
}

const SettingIds<TupleGridKind>& setting_ids(TupleGridKind) {
  static const SettingIds<TupleGridKind> ids{{TupleGridKind::automatic, "auto"},
                                             {TupleGridKind::thesis, "100"}};
  return ids;
}

const SettingIds<AlphaScaling>& setting_ids(AlphaScaling) {
  static const SettingIds<AlphaScaling> ids{{AlphaScaling::linear, "linear"},
                                            {AlphaScaling::root, "root"},
                                            {AlphaScaling::logarithm, "logarithm"}};
  return ids;
}

const SettingIds<LabelText>& setting_ids(LabelText) {
  return label_text_ids();
}

const SettingIds<RecordingKind>& setting_ids(RecordingKind) {
  static const SettingIds<RecordingKind> ids{{RecordingKind::sweep, "sweep"},
                                             {RecordingKind::turntable, "turntable"}};
  return ids;
}

const SettingIds<TurnAxis>& setting_ids(TurnAxis) {
  static const SettingIds<TurnAxis> ids{
      {TurnAxis::up, "up"}, {TurnAxis::x, "x"}, {TurnAxis::y, "y"}, {TurnAxis::z, "z"}};
  return ids;
}

const SettingIds<ObjectKind>& setting_ids(ObjectKind) {
  static const SettingIds<ObjectKind> ids = [] {
    SettingIds<ObjectKind> all;
    for (const ObjectKindInfo& k : object_kinds()) all.emplace_back(k.kind, k.id);
    return all;
  }();
  return ids;
}

const SettingIds<ObjectColour>& setting_ids(ObjectColour) {
  static const SettingIds<ObjectColour> ids = [] {
    SettingIds<ObjectColour> all;
    for (const ObjectColourInfo& c : object_colours()) all.emplace_back(c.colour, c.id);
    return all;
  }();
  return ids;
}

}  // namespace alphascope
