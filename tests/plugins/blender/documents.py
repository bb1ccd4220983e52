"""BML of both dialects, and when its behaviours are realized."""

BML = b"""<?xml version="1.0" encoding="UTF-8"?>
<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="bml1" characterId="anna">
  <speech id="speech1" start="0"><text>No, <sync id="w1"/>not those.</text></speech>
  <gesture id="gesture1" lexeme="NEGATION" mode="LEFT_HAND" start="0.1" ready="0.4" stroke="0.6" end="1.2"/>
  <head id="head1" lexeme="SHAKE" start="gesture1:stroke+0.1" end="gesture1:end"/>
  <faceFacs xmlns="http://www.bml-initiative.org/bml/coreextensions-1.0" id="face1" au="45" start="2.0" end="2.2"/>
  <posture id="posture1"><stance type="STANDING"/></posture>
</bml>"""
REALIZED_S = {
    "gesture1": {"start": 0.1, "ready": 0.4, "stroke": 0.6, "end": 1.2},
    "head1": {"start": 0.7, "end": 1.2},
    "posture1": {"start": 0.0, "end": 3.0},
}
SMARTBODY = b"""<act><participant id="brad" role="actor"/><bml>
<speech id="sp1" ref="line"><sync id="T0"/>Hello<sync id="T1"/></speech>
<head id="h1" type="NOD" start="sp1:T1"/><gesture id="g1" type="RHYTHM" stroke="0.8" relax="1.0"/>
</bml></act>"""
