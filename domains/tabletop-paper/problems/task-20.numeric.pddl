; Problem task-20 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 21: 6 random actions on item-02, item-01, item-04, item-07, item-03, item-08; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-20)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - any-low-narrow-11
    item-02 - any-low-narrow-11
    item-03 - any-low-narrow-11
    item-04 - hollow-00
    item-05 - hollow-00
    item-06 - hollow-00
    item-07 - solid-narrow-10
    item-08 - hollow-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7960, 0.0387, 0.0338) m
    (= (x item-01) 4460) (= (y item-01) 3387) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.06686 0.05162 0.06756 0).
    (can-lift-000-any-low-narrow-11 item-01) (= (x-of-lift-000-any-low-narrow-11 item-01) 10252) (= (y-of-lift-000-any-low-narrow-11 item-01) 10264) (= (z-of-lift-000-any-low-narrow-11 item-01) 12217) (= (cost-of-lift-000-any-low-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-01) 10008) (= (y-of-put-down-lift-000-any-low-narrow-11 item-01) 9992) (= (z-of-put-down-lift-000-any-low-narrow-11 item-01) 7783)
    (can-lift-000d-any-low-narrow-11 item-01) (= (x-of-lift-000d-any-low-narrow-11 item-01) 10500) (= (y-of-lift-000d-any-low-narrow-11 item-01) 10104) (= (z-of-lift-000d-any-low-narrow-11 item-01) 12002) (= (cost-of-lift-000d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-01) 9989) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-01) 7998)
    (can-lift-100-any-low-narrow-11 item-01) (= (x-of-lift-100-any-low-narrow-11 item-01) 9323) (= (y-of-lift-100-any-low-narrow-11 item-01) 9760) (= (z-of-lift-100-any-low-narrow-11 item-01) 12030) (= (cost-of-lift-100-any-low-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-100-any-low-narrow-11 item-01) 9991) (= (z-of-put-down-lift-100-any-low-narrow-11 item-01) 7970)
    (can-lift-100d-any-low-narrow-11 item-01) (= (x-of-lift-100d-any-low-narrow-11 item-01) 9768) (= (y-of-lift-100d-any-low-narrow-11 item-01) 10387) (= (z-of-lift-100d-any-low-narrow-11 item-01) 11996) (= (cost-of-lift-100d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-01) 8004)
    (can-lift-101-any-low-narrow-11 item-01) (= (x-of-lift-101-any-low-narrow-11 item-01) 9831) (= (y-of-lift-101-any-low-narrow-11 item-01) 9481) (= (z-of-lift-101-any-low-narrow-11 item-01) 12462) (= (cost-of-lift-101-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-01) 9990) (= (y-of-put-down-lift-101-any-low-narrow-11 item-01) 9991) (= (z-of-put-down-lift-101-any-low-narrow-11 item-01) 7538)
    (can-lift-101b-any-low-narrow-11 item-01) (= (x-of-lift-101b-any-low-narrow-11 item-01) 10043) (= (y-of-lift-101b-any-low-narrow-11 item-01) 9561) (= (z-of-lift-101b-any-low-narrow-11 item-01) 12001) (= (cost-of-lift-101b-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-01) 7999)
    (can-pull-right-110c-any-low-narrow-11 item-01) (= (x-of-pull-right-110c-any-low-narrow-11 item-01) 9431) (= (y-of-pull-right-110c-any-low-narrow-11 item-01) 9596) (= (cost-of-pull-right-110c-any-low-narrow-11 item-01) 4)
    (can-push-forward-001-any-low-narrow-11 item-01) (= (x-of-push-forward-001-any-low-narrow-11 item-01) 10971) (= (y-of-push-forward-001-any-low-narrow-11 item-01) 9689) (= (cost-of-push-forward-001-any-low-narrow-11 item-01) 4)
    (can-push-forward-001c-any-low-narrow-11 item-01) (= (x-of-push-forward-001c-any-low-narrow-11 item-01) 10848) (= (y-of-push-forward-001c-any-low-narrow-11 item-01) 10180) (= (cost-of-push-forward-001c-any-low-narrow-11 item-01) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-01) (= (x-of-push-forward-left-011-any-low-narrow-11 item-01) 10494) (= (y-of-push-forward-left-011-any-low-narrow-11 item-01) 10234) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-01) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-01) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-01) 10287) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-01) 9591) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-01) 4)
    (can-push-left-010d-any-low-narrow-11 item-01) (= (x-of-push-left-010d-any-low-narrow-11 item-01) 9633) (= (y-of-push-left-010d-any-low-narrow-11 item-01) 10893) (= (cost-of-push-left-010d-any-low-narrow-11 item-01) 34)
    (can-push-right-111c-any-low-narrow-11 item-01) (= (x-of-push-right-111c-any-low-narrow-11 item-01) 9607) (= (y-of-push-right-111c-any-low-narrow-11 item-01) 9179) (= (cost-of-push-right-111c-any-low-narrow-11 item-01) 7)
    ; item-02 starts at (0.4401, 0.2072, 0.0433) m
    (= (x item-02) 901) (= (y item-02) 5072) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.0707 0.05572 0.08661 0).
    (can-lift-000-any-low-narrow-11 item-02) (= (x-of-lift-000-any-low-narrow-11 item-02) 10226) (= (y-of-lift-000-any-low-narrow-11 item-02) 10279) (= (z-of-lift-000-any-low-narrow-11 item-02) 12213) (= (cost-of-lift-000-any-low-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-02) 10004) (= (y-of-put-down-lift-000-any-low-narrow-11 item-02) 9991) (= (z-of-put-down-lift-000-any-low-narrow-11 item-02) 7787)
    (can-lift-000d-any-low-narrow-11 item-02) (= (x-of-lift-000d-any-low-narrow-11 item-02) 10506) (= (y-of-lift-000d-any-low-narrow-11 item-02) 10108) (= (z-of-lift-000d-any-low-narrow-11 item-02) 12002) (= (cost-of-lift-000d-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-02) 10003) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-02) 9991) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-02) 7998)
    (can-lift-100-any-low-narrow-11 item-02) (= (x-of-lift-100-any-low-narrow-11 item-02) 9324) (= (y-of-lift-100-any-low-narrow-11 item-02) 9761) (= (z-of-lift-100-any-low-narrow-11 item-02) 12048) (= (cost-of-lift-100-any-low-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-02) 10001) (= (y-of-put-down-lift-100-any-low-narrow-11 item-02) 9990) (= (z-of-put-down-lift-100-any-low-narrow-11 item-02) 7952)
    (can-lift-100d-any-low-narrow-11 item-02) (= (x-of-lift-100d-any-low-narrow-11 item-02) 9771) (= (y-of-lift-100d-any-low-narrow-11 item-02) 10389) (= (z-of-lift-100d-any-low-narrow-11 item-02) 11996) (= (cost-of-lift-100d-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-02) 9993) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-02) 8004)
    (can-lift-101-any-low-narrow-11 item-02) (= (x-of-lift-101-any-low-narrow-11 item-02) 9833) (= (y-of-lift-101-any-low-narrow-11 item-02) 9487) (= (z-of-lift-101-any-low-narrow-11 item-02) 12491) (= (cost-of-lift-101-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-02) 9993) (= (y-of-put-down-lift-101-any-low-narrow-11 item-02) 9994) (= (z-of-put-down-lift-101-any-low-narrow-11 item-02) 7509)
    (can-lift-101b-any-low-narrow-11 item-02) (= (x-of-lift-101b-any-low-narrow-11 item-02) 10037) (= (y-of-lift-101b-any-low-narrow-11 item-02) 9563) (= (z-of-lift-101b-any-low-narrow-11 item-02) 12001) (= (cost-of-lift-101b-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-02) 9990) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-02) 7999)
    (can-pull-right-110c-any-low-narrow-11 item-02) (= (x-of-pull-right-110c-any-low-narrow-11 item-02) 9431) (= (y-of-pull-right-110c-any-low-narrow-11 item-02) 9590) (= (cost-of-pull-right-110c-any-low-narrow-11 item-02) 4)
    (can-push-forward-001-any-low-narrow-11 item-02) (= (x-of-push-forward-001-any-low-narrow-11 item-02) 10931) (= (y-of-push-forward-001-any-low-narrow-11 item-02) 9730) (= (cost-of-push-forward-001-any-low-narrow-11 item-02) 4)
    (can-push-forward-001c-any-low-narrow-11 item-02) (= (x-of-push-forward-001c-any-low-narrow-11 item-02) 10849) (= (y-of-push-forward-001c-any-low-narrow-11 item-02) 10181) (= (cost-of-push-forward-001c-any-low-narrow-11 item-02) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-02) (= (x-of-push-forward-left-011-any-low-narrow-11 item-02) 10513) (= (y-of-push-forward-left-011-any-low-narrow-11 item-02) 10267) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-02) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-02) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-02) 10287) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-02) 9588) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-02) 4)
    (can-push-left-010d-any-low-narrow-11 item-02) (= (x-of-push-left-010d-any-low-narrow-11 item-02) 9806) (= (y-of-push-left-010d-any-low-narrow-11 item-02) 10847) (= (cost-of-push-left-010d-any-low-narrow-11 item-02) 43)
    (can-push-right-111c-any-low-narrow-11 item-02) (= (x-of-push-right-111c-any-low-narrow-11 item-02) 9458) (= (y-of-push-right-111c-any-low-narrow-11 item-02) 9141) (= (cost-of-push-right-111c-any-low-narrow-11 item-02) 7)
    ; item-03 starts at (0.4593, 0.0810, 0.0222) m
    (= (x item-03) 1093) (= (y item-03) 3810) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1464 0.04512 0.04448 0).
    (can-lift-000-any-low-narrow-11 item-03) (= (x-of-lift-000-any-low-narrow-11 item-03) 10222) (= (y-of-lift-000-any-low-narrow-11 item-03) 10271) (= (z-of-lift-000-any-low-narrow-11 item-03) 12192) (= (cost-of-lift-000-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-03) 10001) (= (y-of-put-down-lift-000-any-low-narrow-11 item-03) 9987) (= (z-of-put-down-lift-000-any-low-narrow-11 item-03) 7808)
    (can-lift-000d-any-low-narrow-11 item-03) (= (x-of-lift-000d-any-low-narrow-11 item-03) 10471) (= (y-of-lift-000d-any-low-narrow-11 item-03) 10099) (= (z-of-lift-000d-any-low-narrow-11 item-03) 12001) (= (cost-of-lift-000d-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-03) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-03) 9986) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-03) 7999)
    (can-lift-100-any-low-narrow-11 item-03) (= (x-of-lift-100-any-low-narrow-11 item-03) 9337) (= (y-of-lift-100-any-low-narrow-11 item-03) 9745) (= (z-of-lift-100-any-low-narrow-11 item-03) 12005) (= (cost-of-lift-100-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-03) 10000) (= (y-of-put-down-lift-100-any-low-narrow-11 item-03) 9989) (= (z-of-put-down-lift-100-any-low-narrow-11 item-03) 7995)
    (can-lift-100d-any-low-narrow-11 item-03) (= (x-of-lift-100d-any-low-narrow-11 item-03) 9766) (= (y-of-lift-100d-any-low-narrow-11 item-03) 10384) (= (z-of-lift-100d-any-low-narrow-11 item-03) 11997) (= (cost-of-lift-100d-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-03) 10000) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-03) 9984) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-03) 8003)
    (can-lift-101-any-low-narrow-11 item-03) (= (x-of-lift-101-any-low-narrow-11 item-03) 9832) (= (y-of-lift-101-any-low-narrow-11 item-03) 9474) (= (z-of-lift-101-any-low-narrow-11 item-03) 12390) (= (cost-of-lift-101-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-03) 9998) (= (y-of-put-down-lift-101-any-low-narrow-11 item-03) 9989) (= (z-of-put-down-lift-101-any-low-narrow-11 item-03) 7610)
    (can-lift-101b-any-low-narrow-11 item-03) (= (x-of-lift-101b-any-low-narrow-11 item-03) 10055) (= (y-of-lift-101b-any-low-narrow-11 item-03) 9551) (= (z-of-lift-101b-any-low-narrow-11 item-03) 12003) (= (cost-of-lift-101b-any-low-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-03) 10000) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-03) 9986) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-03) 7997)
    (can-pull-right-110c-any-low-narrow-11 item-03) (= (x-of-pull-right-110c-any-low-narrow-11 item-03) 9447) (= (y-of-pull-right-110c-any-low-narrow-11 item-03) 9572) (= (cost-of-pull-right-110c-any-low-narrow-11 item-03) 4)
    (can-push-forward-001-any-low-narrow-11 item-03) (= (x-of-push-forward-001-any-low-narrow-11 item-03) 10953) (= (y-of-push-forward-001-any-low-narrow-11 item-03) 9727) (= (cost-of-push-forward-001-any-low-narrow-11 item-03) 4)
    (can-push-forward-001c-any-low-narrow-11 item-03) (= (x-of-push-forward-001c-any-low-narrow-11 item-03) 10853) (= (y-of-push-forward-001c-any-low-narrow-11 item-03) 10185) (= (cost-of-push-forward-001c-any-low-narrow-11 item-03) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-03) (= (x-of-push-forward-left-011-any-low-narrow-11 item-03) 10628) (= (y-of-push-forward-left-011-any-low-narrow-11 item-03) 10478) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-03) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-03) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-03) 10287) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-03) 9587) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-03) 4)
    (can-push-left-010d-any-low-narrow-11 item-03) (= (x-of-push-left-010d-any-low-narrow-11 item-03) 9982) (= (y-of-push-left-010d-any-low-narrow-11 item-03) 11047) (= (cost-of-push-left-010d-any-low-narrow-11 item-03) 22)
    (can-push-right-111c-any-low-narrow-11 item-03) (= (x-of-push-right-111c-any-low-narrow-11 item-03) 9848) (= (y-of-push-right-111c-any-low-narrow-11 item-03) 9155) (= (cost-of-push-right-111c-any-low-narrow-11 item-03) 7)
    ; item-04 starts at (0.8752, 0.2158, 0.0115) m
    (= (x item-04) 5252) (= (y item-04) 5158) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1253 0.1253 0.02303 2).
    ; Not for item-04:
    ; lift-011a-hollow-00: keeps its promise with such objects in about 5 of 30 only.
    ; lift-110a-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-04) (= (x-of-lift-000-hollow-00 item-04) 10032) (= (y-of-lift-000-hollow-00 item-04) 10619) (= (z-of-lift-000-hollow-00 item-04) 12291) (= (cost-of-lift-000-hollow-00 item-04) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-04) 9947) (= (y-of-put-down-lift-000-hollow-00 item-04) 9933) (= (z-of-put-down-lift-000-hollow-00 item-04) 7709)
    (can-lift-000a-hollow-00 item-04) (= (x-of-lift-000a-hollow-00 item-04) 10489) (= (y-of-lift-000a-hollow-00 item-04) 10719) (= (z-of-lift-000a-hollow-00 item-04) 12436) (= (cost-of-lift-000a-hollow-00 item-04) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-04) 9998) (= (y-of-put-down-lift-000a-hollow-00 item-04) 9954) (= (z-of-put-down-lift-000a-hollow-00 item-04) 7564)
    (= (x-of-lift-011a-hollow-00 item-04) 10407) (= (y-of-lift-011a-hollow-00 item-04) 10290) (= (z-of-lift-011a-hollow-00 item-04) 11999) (= (cost-of-lift-011a-hollow-00 item-04) 168)
    (= (x-of-put-down-lift-011a-hollow-00 item-04) 10005) (= (y-of-put-down-lift-011a-hollow-00 item-04) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-04) 8001)
    (can-lift-100a-hollow-00 item-04) (= (x-of-lift-100a-hollow-00 item-04) 9557) (= (y-of-lift-100a-hollow-00 item-04) 10589) (= (z-of-lift-100a-hollow-00 item-04) 11994) (= (cost-of-lift-100a-hollow-00 item-04) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-04) 10003) (= (y-of-put-down-lift-100a-hollow-00 item-04) 9970) (= (z-of-put-down-lift-100a-hollow-00 item-04) 8006)
    (can-lift-101a-hollow-00 item-04) (= (x-of-lift-101a-hollow-00 item-04) 10039) (= (y-of-lift-101a-hollow-00 item-04) 9382) (= (z-of-lift-101a-hollow-00 item-04) 11995) (= (cost-of-lift-101a-hollow-00 item-04) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-04) 10001) (= (y-of-put-down-lift-101a-hollow-00 item-04) 9957) (= (z-of-put-down-lift-101a-hollow-00 item-04) 8005)
    (= (x-of-lift-110a-hollow-00 item-04) 9588) (= (y-of-lift-110a-hollow-00 item-04) 10125) (= (z-of-lift-110a-hollow-00 item-04) 11998) (= (cost-of-lift-110a-hollow-00 item-04) 278)
    (= (x-of-put-down-lift-110a-hollow-00 item-04) 9998) (= (y-of-put-down-lift-110a-hollow-00 item-04) 10005) (= (z-of-put-down-lift-110a-hollow-00 item-04) 8002)
    (can-pull-110a-hollow-00 item-04) (= (x-of-pull-110a-hollow-00 item-04) 9655) (= (y-of-pull-110a-hollow-00 item-04) 10120) (= (cost-of-pull-110a-hollow-00 item-04) 7)
    (can-pull-right-111a-hollow-00 item-04) (= (x-of-pull-right-111a-hollow-00 item-04) 9629) (= (y-of-pull-right-111a-hollow-00 item-04) 9710) (= (cost-of-pull-right-111a-hollow-00 item-04) 4)
    (can-push-forward-left-011a-hollow-00 item-04) (= (x-of-push-forward-left-011a-hollow-00 item-04) 10459) (= (y-of-push-forward-left-011a-hollow-00 item-04) 10281) (= (cost-of-push-forward-left-011a-hollow-00 item-04) 22)
    (can-push-forward-right-001a-hollow-00 item-04) (= (x-of-push-forward-right-001a-hollow-00 item-04) 10394) (= (y-of-push-forward-right-001a-hollow-00 item-04) 9579) (= (cost-of-push-forward-right-001a-hollow-00 item-04) 4)
    (= (x-of-push-left-000-hollow-00 item-04) 10003) (= (y-of-push-left-000-hollow-00 item-04) 10259) (= (cost-of-push-left-000-hollow-00 item-04) 278)
    (can-push-left-010a-hollow-00 item-04) (= (x-of-push-left-010a-hollow-00 item-04) 9949) (= (y-of-push-left-010a-hollow-00 item-04) 10172) (= (cost-of-push-left-010a-hollow-00 item-04) 18)
    (can-push-left-011-hollow-00 item-04) (= (x-of-push-left-011-hollow-00 item-04) 10099) (= (y-of-push-left-011-hollow-00 item-04) 10322) (= (cost-of-push-left-011-hollow-00 item-04) 4)
    (can-push-right-111-hollow-00 item-04) (= (x-of-push-right-111-hollow-00 item-04) 10066) (= (y-of-push-right-111-hollow-00 item-04) 9828) (= (cost-of-push-right-111-hollow-00 item-04) 7)
    ; item-05 starts at (0.6768, 0.1969, 0.0133) m
    (= (x item-05) 3268) (= (y item-05) 4969) (= (z item-05) 0)
    ; What each operator promises for item-05 (features 0.1707 0.1707 0.02656 2).
    ; Not for item-05:
    ; lift-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-05) (= (x-of-lift-000-hollow-00 item-05) 10004) (= (y-of-lift-000-hollow-00 item-05) 11043) (= (z-of-lift-000-hollow-00 item-05) 12068) (= (cost-of-lift-000-hollow-00 item-05) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-05) 10008) (= (y-of-put-down-lift-000-hollow-00 item-05) 9967) (= (z-of-put-down-lift-000-hollow-00 item-05) 7932)
    (can-lift-000a-hollow-00 item-05) (= (x-of-lift-000a-hollow-00 item-05) 10488) (= (y-of-lift-000a-hollow-00 item-05) 10936) (= (z-of-lift-000a-hollow-00 item-05) 12446) (= (cost-of-lift-000a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-05) 9993) (= (y-of-put-down-lift-000a-hollow-00 item-05) 9954) (= (z-of-put-down-lift-000a-hollow-00 item-05) 7554)
    (can-lift-011a-hollow-00 item-05) (= (x-of-lift-011a-hollow-00 item-05) 10404) (= (y-of-lift-011a-hollow-00 item-05) 10289) (= (z-of-lift-011a-hollow-00 item-05) 12000) (= (cost-of-lift-011a-hollow-00 item-05) 108)
    (= (x-of-put-down-lift-011a-hollow-00 item-05) 10006) (= (y-of-put-down-lift-011a-hollow-00 item-05) 10009) (= (z-of-put-down-lift-011a-hollow-00 item-05) 8000)
    (can-lift-100a-hollow-00 item-05) (= (x-of-lift-100a-hollow-00 item-05) 9496) (= (y-of-lift-100a-hollow-00 item-05) 10796) (= (z-of-lift-100a-hollow-00 item-05) 11979) (= (cost-of-lift-100a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-05) 9994) (= (y-of-put-down-lift-100a-hollow-00 item-05) 9959) (= (z-of-put-down-lift-100a-hollow-00 item-05) 8021)
    (can-lift-101a-hollow-00 item-05) (= (x-of-lift-101a-hollow-00 item-05) 10012) (= (y-of-lift-101a-hollow-00 item-05) 9213) (= (z-of-lift-101a-hollow-00 item-05) 11772) (= (cost-of-lift-101a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-05) 10032) (= (y-of-put-down-lift-101a-hollow-00 item-05) 9976) (= (z-of-put-down-lift-101a-hollow-00 item-05) 8228)
    (= (x-of-lift-110a-hollow-00 item-05) 9600) (= (y-of-lift-110a-hollow-00 item-05) 10125) (= (z-of-lift-110a-hollow-00 item-05) 11997) (= (cost-of-lift-110a-hollow-00 item-05) 238)
    (= (x-of-put-down-lift-110a-hollow-00 item-05) 9998) (= (y-of-put-down-lift-110a-hollow-00 item-05) 10005) (= (z-of-put-down-lift-110a-hollow-00 item-05) 8003)
    (can-pull-110a-hollow-00 item-05) (= (x-of-pull-110a-hollow-00 item-05) 9697) (= (y-of-pull-110a-hollow-00 item-05) 10119) (= (cost-of-pull-110a-hollow-00 item-05) 11)
    (can-pull-right-111a-hollow-00 item-05) (= (x-of-pull-right-111a-hollow-00 item-05) 9614) (= (y-of-pull-right-111a-hollow-00 item-05) 9661) (= (cost-of-pull-right-111a-hollow-00 item-05) 4)
    (can-push-forward-left-011a-hollow-00 item-05) (= (x-of-push-forward-left-011a-hollow-00 item-05) 10439) (= (y-of-push-forward-left-011a-hollow-00 item-05) 10286) (= (cost-of-push-forward-left-011a-hollow-00 item-05) 43)
    (can-push-forward-right-001a-hollow-00 item-05) (= (x-of-push-forward-right-001a-hollow-00 item-05) 10358) (= (y-of-push-forward-right-001a-hollow-00 item-05) 9588) (= (cost-of-push-forward-right-001a-hollow-00 item-05) 4)
    (= (x-of-push-left-000-hollow-00 item-05) 10000) (= (y-of-push-left-000-hollow-00 item-05) 10241) (= (cost-of-push-left-000-hollow-00 item-05) 278)
    (can-push-left-010a-hollow-00 item-05) (= (x-of-push-left-010a-hollow-00 item-05) 9840) (= (y-of-push-left-010a-hollow-00 item-05) 10425) (= (cost-of-push-left-010a-hollow-00 item-05) 7)
    (can-push-left-011-hollow-00 item-05) (= (x-of-push-left-011-hollow-00 item-05) 10417) (= (y-of-push-left-011-hollow-00 item-05) 11276) (= (cost-of-push-left-011-hollow-00 item-05) 4)
    (can-push-right-111-hollow-00 item-05) (= (x-of-push-right-111-hollow-00 item-05) 10070) (= (y-of-push-right-111-hollow-00 item-05) 9831) (= (cost-of-push-right-111-hollow-00 item-05) 7)
    ; item-06 starts at (0.5113, -0.1241, 0.0128) m
    (= (x item-06) 1613) (= (y item-06) 1759) (= (z item-06) 0)
    ; What each operator promises for item-06 (features 0.1487 0.1487 0.02555 2).
    ; Not for item-06:
    ; lift-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-06) (= (x-of-lift-000-hollow-00 item-06) 10013) (= (y-of-lift-000-hollow-00 item-06) 10920) (= (z-of-lift-000-hollow-00 item-06) 12164) (= (cost-of-lift-000-hollow-00 item-06) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-06) 9988) (= (y-of-put-down-lift-000-hollow-00 item-06) 9954) (= (z-of-put-down-lift-000-hollow-00 item-06) 7836)
    (can-lift-000a-hollow-00 item-06) (= (x-of-lift-000a-hollow-00 item-06) 10483) (= (y-of-lift-000a-hollow-00 item-06) 10842) (= (z-of-lift-000a-hollow-00 item-06) 12447) (= (cost-of-lift-000a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-06) 9998) (= (y-of-put-down-lift-000a-hollow-00 item-06) 9957) (= (z-of-put-down-lift-000a-hollow-00 item-06) 7553)
    (can-lift-011a-hollow-00 item-06) (= (x-of-lift-011a-hollow-00 item-06) 10439) (= (y-of-lift-011a-hollow-00 item-06) 10286) (= (z-of-lift-011a-hollow-00 item-06) 12000) (= (cost-of-lift-011a-hollow-00 item-06) 70)
    (= (x-of-put-down-lift-011a-hollow-00 item-06) 10004) (= (y-of-put-down-lift-011a-hollow-00 item-06) 10007) (= (z-of-put-down-lift-011a-hollow-00 item-06) 8000)
    (can-lift-100a-hollow-00 item-06) (= (x-of-lift-100a-hollow-00 item-06) 9595) (= (y-of-lift-100a-hollow-00 item-06) 10710) (= (z-of-lift-100a-hollow-00 item-06) 11993) (= (cost-of-lift-100a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-06) 9999) (= (y-of-put-down-lift-100a-hollow-00 item-06) 9968) (= (z-of-put-down-lift-100a-hollow-00 item-06) 8007)
    (can-lift-101a-hollow-00 item-06) (= (x-of-lift-101a-hollow-00 item-06) 10026) (= (y-of-lift-101a-hollow-00 item-06) 9265) (= (z-of-lift-101a-hollow-00 item-06) 11963) (= (cost-of-lift-101a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-06) 9993) (= (y-of-put-down-lift-101a-hollow-00 item-06) 9956) (= (z-of-put-down-lift-101a-hollow-00 item-06) 8037)
    (= (x-of-lift-110a-hollow-00 item-06) 9594) (= (y-of-lift-110a-hollow-00 item-06) 10125) (= (z-of-lift-110a-hollow-00 item-06) 11998) (= (cost-of-lift-110a-hollow-00 item-06) 238)
    (= (x-of-put-down-lift-110a-hollow-00 item-06) 9998) (= (y-of-put-down-lift-110a-hollow-00 item-06) 10005) (= (z-of-put-down-lift-110a-hollow-00 item-06) 8002)
    (can-pull-110a-hollow-00 item-06) (= (x-of-pull-110a-hollow-00 item-06) 9695) (= (y-of-pull-110a-hollow-00 item-06) 10114) (= (cost-of-pull-110a-hollow-00 item-06) 11)
    (can-pull-right-111a-hollow-00 item-06) (= (x-of-pull-right-111a-hollow-00 item-06) 9585) (= (y-of-pull-right-111a-hollow-00 item-06) 9678) (= (cost-of-pull-right-111a-hollow-00 item-06) 4)
    (can-push-forward-left-011a-hollow-00 item-06) (= (x-of-push-forward-left-011a-hollow-00 item-06) 10441) (= (y-of-push-forward-left-011a-hollow-00 item-06) 10284) (= (cost-of-push-forward-left-011a-hollow-00 item-06) 70)
    (can-push-forward-right-001a-hollow-00 item-06) (= (x-of-push-forward-right-001a-hollow-00 item-06) 10382) (= (y-of-push-forward-right-001a-hollow-00 item-06) 9583) (= (cost-of-push-forward-right-001a-hollow-00 item-06) 4)
    (= (x-of-push-left-000-hollow-00 item-06) 10002) (= (y-of-push-left-000-hollow-00 item-06) 10256) (= (cost-of-push-left-000-hollow-00 item-06) 278)
    (can-push-left-010a-hollow-00 item-06) (= (x-of-push-left-010a-hollow-00 item-06) 9831) (= (y-of-push-left-010a-hollow-00 item-06) 10451) (= (cost-of-push-left-010a-hollow-00 item-06) 7)
    (can-push-left-011-hollow-00 item-06) (= (x-of-push-left-011-hollow-00 item-06) 10138) (= (y-of-push-left-011-hollow-00 item-06) 10588) (= (cost-of-push-left-011-hollow-00 item-06) 4)
    (can-push-right-111-hollow-00 item-06) (= (x-of-push-right-111-hollow-00 item-06) 10074) (= (y-of-push-right-111-hollow-00 item-06) 9830) (= (cost-of-push-right-111-hollow-00 item-06) 7)
    ; item-07 starts at (0.8426, -0.1174, 0.0178) m
    (= (x item-07) 4926) (= (y item-07) 1826) (= (z item-07) 0)
    ; What each operator promises for item-07 (features 0.03521 0.1658 0.03565 0).
    ; Not for item-07:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    (= (x-of-lift-100c-solid-narrow-10 item-07) 9410) (= (y-of-lift-100c-solid-narrow-10 item-07) 9734) (= (z-of-lift-100c-solid-narrow-10 item-07) 12220) (= (cost-of-lift-100c-solid-narrow-10 item-07) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-07) 10004) (= (y-of-put-down-lift-100c-solid-narrow-10 item-07) 9987) (= (z-of-put-down-lift-100c-solid-narrow-10 item-07) 7780)
    (= (x-of-lift-101-solid-narrow-10 item-07) 9844) (= (y-of-lift-101-solid-narrow-10 item-07) 9450) (= (z-of-lift-101-solid-narrow-10 item-07) 12446) (= (cost-of-lift-101-solid-narrow-10 item-07) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-07) 10006) (= (y-of-put-down-lift-101-solid-narrow-10 item-07) 9993) (= (z-of-put-down-lift-101-solid-narrow-10 item-07) 7554)
    (can-pull-110-solid-narrow-10 item-07) (= (x-of-pull-110-solid-narrow-10 item-07) 9264) (= (y-of-pull-110-solid-narrow-10 item-07) 9825) (= (cost-of-pull-110-solid-narrow-10 item-07) 4)
    (can-pull-left-010c-solid-narrow-10 item-07) (= (x-of-pull-left-010c-solid-narrow-10 item-07) 9732) (= (y-of-pull-left-010c-solid-narrow-10 item-07) 10189) (= (cost-of-pull-left-010c-solid-narrow-10 item-07) 4)
    (can-pull-right-100c-solid-narrow-10 item-07) (= (x-of-pull-right-100c-solid-narrow-10 item-07) 9642) (= (y-of-pull-right-100c-solid-narrow-10 item-07) 9433) (= (cost-of-pull-right-100c-solid-narrow-10 item-07) 21)
    (can-push-forward-001-solid-narrow-10 item-07) (= (x-of-push-forward-001-solid-narrow-10 item-07) 10900) (= (y-of-push-forward-001-solid-narrow-10 item-07) 9845) (= (cost-of-push-forward-001-solid-narrow-10 item-07) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-07) (= (x-of-push-forward-left-000c-solid-narrow-10 item-07) 10537) (= (y-of-push-forward-left-000c-solid-narrow-10 item-07) 10120) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-07) 9)
    (can-push-forward-right-101-solid-narrow-10 item-07) (= (x-of-push-forward-right-101-solid-narrow-10 item-07) 10325) (= (y-of-push-forward-right-101-solid-narrow-10 item-07) 9530) (= (cost-of-push-forward-right-101-solid-narrow-10 item-07) 9)
    (can-push-forward-right-111-solid-narrow-10 item-07) (= (x-of-push-forward-right-111-solid-narrow-10 item-07) 10377) (= (y-of-push-forward-right-111-solid-narrow-10 item-07) 9533) (= (cost-of-push-forward-right-111-solid-narrow-10 item-07) 4)
    (can-push-left-011c-solid-narrow-10 item-07) (= (x-of-push-left-011c-solid-narrow-10 item-07) 10194) (= (y-of-push-left-011c-solid-narrow-10 item-07) 10592) (= (cost-of-push-left-011c-solid-narrow-10 item-07) 4)
    ; item-08 starts at (0.6970, -0.2061, 0.0151) m
    (= (x item-08) 3470) (= (y item-08) 939) (= (z item-08) 0)
    ; What each operator promises for item-08 (features 0.1395 0.1395 0.03039 2).
    ; Not for item-08:
    ; lift-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-08) (= (x-of-lift-000-hollow-00 item-08) 10018) (= (y-of-lift-000-hollow-00 item-08) 10844) (= (z-of-lift-000-hollow-00 item-08) 12203) (= (cost-of-lift-000-hollow-00 item-08) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-08) 9978) (= (y-of-put-down-lift-000-hollow-00 item-08) 9950) (= (z-of-put-down-lift-000-hollow-00 item-08) 7797)
    (can-lift-000a-hollow-00 item-08) (= (x-of-lift-000a-hollow-00 item-08) 10483) (= (y-of-lift-000a-hollow-00 item-08) 10797) (= (z-of-lift-000a-hollow-00 item-08) 12469) (= (cost-of-lift-000a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-08) 9996) (= (y-of-put-down-lift-000a-hollow-00 item-08) 9958) (= (z-of-put-down-lift-000a-hollow-00 item-08) 7531)
    (can-lift-011a-hollow-00 item-08) (= (x-of-lift-011a-hollow-00 item-08) 10424) (= (y-of-lift-011a-hollow-00 item-08) 10285) (= (z-of-lift-011a-hollow-00 item-08) 11998) (= (cost-of-lift-011a-hollow-00 item-08) 77)
    (= (x-of-put-down-lift-011a-hollow-00 item-08) 10003) (= (y-of-put-down-lift-011a-hollow-00 item-08) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-08) 8002)
    (can-lift-100a-hollow-00 item-08) (= (x-of-lift-100a-hollow-00 item-08) 9573) (= (y-of-lift-100a-hollow-00 item-08) 10668) (= (z-of-lift-100a-hollow-00 item-08) 11991) (= (cost-of-lift-100a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-08) 10001) (= (y-of-put-down-lift-100a-hollow-00 item-08) 9974) (= (z-of-put-down-lift-100a-hollow-00 item-08) 8009)
    (can-lift-101a-hollow-00 item-08) (= (x-of-lift-101a-hollow-00 item-08) 10027) (= (y-of-lift-101a-hollow-00 item-08) 9309) (= (z-of-lift-101a-hollow-00 item-08) 12006) (= (cost-of-lift-101a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-08) 9994) (= (y-of-put-down-lift-101a-hollow-00 item-08) 9957) (= (z-of-put-down-lift-101a-hollow-00 item-08) 7994)
    (= (x-of-lift-110a-hollow-00 item-08) 9594) (= (y-of-lift-110a-hollow-00 item-08) 10125) (= (z-of-lift-110a-hollow-00 item-08) 11998) (= (cost-of-lift-110a-hollow-00 item-08) 238)
    (= (x-of-put-down-lift-110a-hollow-00 item-08) 9997) (= (y-of-put-down-lift-110a-hollow-00 item-08) 10005) (= (z-of-put-down-lift-110a-hollow-00 item-08) 8002)
    (can-pull-110a-hollow-00 item-08) (= (x-of-pull-110a-hollow-00 item-08) 9689) (= (y-of-pull-110a-hollow-00 item-08) 10114) (= (cost-of-pull-110a-hollow-00 item-08) 11)
    (can-pull-right-111a-hollow-00 item-08) (= (x-of-pull-right-111a-hollow-00 item-08) 9663) (= (y-of-pull-right-111a-hollow-00 item-08) 9737) (= (cost-of-pull-right-111a-hollow-00 item-08) 4)
    (can-push-forward-left-011a-hollow-00 item-08) (= (x-of-push-forward-left-011a-hollow-00 item-08) 10451) (= (y-of-push-forward-left-011a-hollow-00 item-08) 10284) (= (cost-of-push-forward-left-011a-hollow-00 item-08) 64)
    (can-push-forward-right-001a-hollow-00 item-08) (= (x-of-push-forward-right-001a-hollow-00 item-08) 10379) (= (y-of-push-forward-right-001a-hollow-00 item-08) 9583) (= (cost-of-push-forward-right-001a-hollow-00 item-08) 4)
    (= (x-of-push-left-000-hollow-00 item-08) 10003) (= (y-of-push-left-000-hollow-00 item-08) 10261) (= (cost-of-push-left-000-hollow-00 item-08) 278)
    (can-push-left-010a-hollow-00 item-08) (= (x-of-push-left-010a-hollow-00 item-08) 9859) (= (y-of-push-left-010a-hollow-00 item-08) 10378) (= (cost-of-push-left-010a-hollow-00 item-08) 7)
    (can-push-left-011-hollow-00 item-08) (= (x-of-push-left-011-hollow-00 item-08) 10099) (= (y-of-push-left-011-hollow-00 item-08) 10404) (= (cost-of-push-left-011-hollow-00 item-08) 4)
    (can-push-right-111-hollow-00 item-08) (= (x-of-push-right-111-hollow-00 item-08) 10061) (= (y-of-push-right-111-hollow-00 item-08) 9820) (= (cost-of-push-right-111-hollow-00 item-08) 7))
  (:goal (and
    ; item-01 shall come to (0.7685, 0.0207, 0.0338) m, 33 mm from where it starts
    (<= (x item-01) 4640) (>= (x item-01) 3730)
    (<= (+ (x item-01) (y item-01)) 8035) (>= (+ (x item-01) (y item-01)) 6748)
    (<= (y item-01) 3662) (>= (y item-01) 2752)
    (<= (+ (y item-01) 334) (x item-01)) (<= (x item-01) (+ (y item-01) 1621))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.4295, 0.1909, 0.0433) m, 19 mm from where it starts
    (<= (x item-02) 1250) (>= (x item-02) 340)
    (<= (+ (x item-02) (y item-02)) 6348) (>= (+ (x item-02) (y item-02)) 5061)
    (<= (y item-02) 5364) (>= (y item-02) 4454)
    (<= (y item-02) (+ (x item-02) 4758)) (<= (+ (x item-02) 3471) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.4594, -0.0512, 0.0222) m, 132 mm from where it starts
    (<= (x item-03) 1549) (>= (x item-03) 639)
    (<= (+ (x item-03) (y item-03)) 4225) (>= (+ (x item-03) (y item-03)) 2938)
    (<= (y item-03) 2942) (>= (y item-03) 2033)
    (<= (y item-03) (+ (x item-03) 2037)) (<= (+ (x item-03) 750) (y item-03))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.8341, 0.2060, 0.0115) m, 42 mm from where it starts
    (<= (x item-04) 5297) (>= (x item-04) 4387)
    (<= (+ (x item-04) (y item-04)) 10546) (>= (+ (x item-04) (y item-04)) 9259)
    (<= (y item-04) 5515) (>= (y item-04) 4605)
    (<= (y item-04) (+ (x item-04) 862)) (<= (x item-04) (+ (y item-04) 425))
    (>= (z item-04) 0) (<= (z item-04) 0)
    ; item-05 shall come to (0.6768, 0.1969, 0.0133) m, 0 mm from where it starts
    (<= (x item-05) 3723) (>= (x item-05) 2813)
    (<= (+ (x item-05) (y item-05)) 8881) (>= (+ (x item-05) (y item-05)) 7593)
    (<= (y item-05) 5424) (>= (y item-05) 4514)
    (<= (y item-05) (+ (x item-05) 2345)) (<= (+ (x item-05) 1057) (y item-05))
    (>= (z item-05) 0) (<= (z item-05) 0)
    ; item-06 shall come to (0.5127, -0.1394, 0.0128) m, 15 mm from where it starts
    (<= (x item-06) 2082) (>= (x item-06) 1172)
    (<= (+ (x item-06) (y item-06)) 3877) (>= (+ (x item-06) (y item-06)) 2590)
    (<= (y item-06) 2061) (>= (y item-06) 1151)
    (<= (y item-06) (+ (x item-06) 623)) (<= (x item-06) (+ (y item-06) 664))
    (>= (z item-06) 0) (<= (z item-06) 0)
    ; item-07 shall come to (0.8634, -0.1321, 0.0178) m, 25 mm from where it starts
    (<= (x item-07) 5589) (>= (x item-07) 4679)
    (<= (+ (x item-07) (y item-07)) 7457) (>= (+ (x item-07) (y item-07)) 6170)
    (<= (y item-07) 2134) (>= (y item-07) 1224)
    (<= (+ (y item-07) 2811) (x item-07)) (<= (x item-07) (+ (y item-07) 4098))
    (>= (z item-07) 0) (<= (z item-07) 0)
    ; item-08 shall come to (0.7083, -0.2162, 0.0152) m, 15 mm from where it starts
    (<= (x item-08) 4037) (>= (x item-08) 3127)
    (<= (+ (x item-08) (y item-08)) 5064) (>= (+ (x item-08) (y item-08)) 3777)
    (<= (y item-08) 1293) (>= (y item-08) 383)
    (<= (+ (y item-08) 2101) (x item-08)) (<= (x item-08) (+ (y item-08) 3388))
    (>= (z item-08) 0) (<= (z item-08) 0)))
  (:metric minimize (total-cost)))
