; Problem crowded-4-17 of the learned domain places, for its encoding numeric.
; How it came about: crowded, drawn with seed 18; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem crowded-4-17)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-10
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 - hollow-wide-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5886, 0.0648, 0.0142) m
    (= (x item-01) 2386) (= (y item-01) 3648) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.05983 0.108 0.02844 0).
    ; Not for item-01:
    ; push-forward-left-1010-solid-low-10: scatters more than it moves.
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: keeps its promise in 3 of 31 rehearsals only.
    ; push-right-0010-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    ; push-right-0011-solid-low-10: keeps its promise in 3 of 31 rehearsals only.
    (can-lift-0010-solid-low-10 item-01) (= (x-of-lift-0010-solid-low-10 item-01) 10275) (= (y-of-lift-0010-solid-low-10 item-01) 10233) (= (z-of-lift-0010-solid-low-10 item-01) 12306) (= (cost-of-lift-0010-solid-low-10 item-01) 14)
    (= (x-of-put-down-lift-0010-solid-low-10 item-01) 10001) (= (y-of-put-down-lift-0010-solid-low-10 item-01) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-01) 7694)
    (can-lift-1001c-solid-low-10 item-01) (= (x-of-lift-1001c-solid-low-10 item-01) 10269) (= (y-of-lift-1001c-solid-low-10 item-01) 9483) (= (z-of-lift-1001c-solid-low-10 item-01) 12009) (= (cost-of-lift-1001c-solid-low-10 item-01) 120)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-01) 9999) (= (y-of-put-down-lift-1001c-solid-low-10 item-01) 9992) (= (z-of-put-down-lift-1001c-solid-low-10 item-01) 7991)
    (can-pull-0000b-solid-low-10 item-01) (= (x-of-pull-0000b-solid-low-10 item-01) 9543) (= (y-of-pull-0000b-solid-low-10 item-01) 9856) (= (cost-of-pull-0000b-solid-low-10 item-01) 14)
    (can-pull-0100-solid-low-10 item-01) (= (x-of-pull-0100-solid-low-10 item-01) 9270) (= (y-of-pull-0100-solid-low-10 item-01) 9940) (= (cost-of-pull-0100-solid-low-10 item-01) 7)
    (can-pull-0100c-solid-low-10 item-01) (= (x-of-pull-0100c-solid-low-10 item-01) 9404) (= (y-of-pull-0100c-solid-low-10 item-01) 10204) (= (cost-of-pull-0100c-solid-low-10 item-01) 11)
    (can-pull-0110c-solid-low-10 item-01) (= (x-of-pull-0110c-solid-low-10 item-01) 9798) (= (y-of-pull-0110c-solid-low-10 item-01) 9993) (= (cost-of-pull-0110c-solid-low-10 item-01) 4)
    (can-pull-left-1110c-solid-low-10 item-01) (= (x-of-pull-left-1110c-solid-low-10 item-01) 9827) (= (y-of-pull-left-1110c-solid-low-10 item-01) 10115) (= (cost-of-pull-left-1110c-solid-low-10 item-01) 4)
    (can-push-forward-0101c-solid-low-10 item-01) (= (x-of-push-forward-0101c-solid-low-10 item-01) 10253) (= (y-of-push-forward-0101c-solid-low-10 item-01) 9879) (= (cost-of-push-forward-0101c-solid-low-10 item-01) 14)
    (can-push-forward-1011-solid-low-10 item-01) (= (x-of-push-forward-1011-solid-low-10 item-01) 10898) (= (y-of-push-forward-1011-solid-low-10 item-01) 10145) (= (cost-of-push-forward-1011-solid-low-10 item-01) 4)
    (can-push-forward-left-1001c-solid-low-10 item-01) (= (x-of-push-forward-left-1001c-solid-low-10 item-01) 10272) (= (y-of-push-forward-left-1001c-solid-low-10 item-01) 10356) (= (cost-of-push-forward-left-1001c-solid-low-10 item-01) 42)
    (= (x-of-push-forward-left-1010-solid-low-10 item-01) 10102) (= (y-of-push-forward-left-1010-solid-low-10 item-01) 10119) (= (cost-of-push-forward-left-1010-solid-low-10 item-01) 87)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-01) 10145) (= (y-of-push-forward-left-1100c-solid-low-10 item-01) 10016) (= (cost-of-push-forward-left-1100c-solid-low-10 item-01) 4)
    (can-push-forward-right-0111c-solid-low-10 item-01) (= (x-of-push-forward-right-0111c-solid-low-10 item-01) 10533) (= (y-of-push-forward-right-0111c-solid-low-10 item-01) 9418) (= (cost-of-push-forward-right-0111c-solid-low-10 item-01) 111)
    (can-push-forward-right-1111-solid-low-10 item-01) (= (x-of-push-forward-right-1111-solid-low-10 item-01) 10560) (= (y-of-push-forward-right-1111-solid-low-10 item-01) 9974) (= (cost-of-push-forward-right-1111-solid-low-10 item-01) 94)
    (= (x-of-push-left-1000-solid-low-10 item-01) 9943) (= (y-of-push-left-1000-solid-low-10 item-01) 10292) (= (cost-of-push-left-1000-solid-low-10 item-01) 212)
    (can-push-right-0001b-solid-low-10 item-01) (= (x-of-push-right-0001b-solid-low-10 item-01) 9900) (= (y-of-push-right-0001b-solid-low-10 item-01) 9615) (= (cost-of-push-right-0001b-solid-low-10 item-01) 11)
    (= (x-of-push-right-0010-solid-low-10 item-01) 10088) (= (y-of-push-right-0010-solid-low-10 item-01) 9809) (= (cost-of-push-right-0010-solid-low-10 item-01) 241)
    (= (x-of-push-right-0011-solid-low-10 item-01) 10145) (= (y-of-push-right-0011-solid-low-10 item-01) 9630) (= (cost-of-push-right-0011-solid-low-10 item-01) 212)
    (can-stay-1101-solid-low-10 item-01) (= (x-of-stay-1101-solid-low-10 item-01) 9987) (= (y-of-stay-1101-solid-low-10 item-01) 10309) (= (cost-of-stay-1101-solid-low-10 item-01) 11)
    ; item-02 starts at (0.5356, 0.1602, 0.0236) m
    (= (x item-02) 1856) (= (y item-02) 4602) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.03885 0.1252 0.04715 0).
    ; Not for item-02:
    ; lift-0010-solid-low-10: keeps its promise with such objects in about 5 of 31 only.
    ; push-forward-left-1001c-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    ; push-forward-right-0111c-solid-low-10: scatters more than it moves.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-02) 10272) (= (y-of-lift-0010-solid-low-10 item-02) 10237) (= (z-of-lift-0010-solid-low-10 item-02) 12363) (= (cost-of-lift-0010-solid-low-10 item-02) 171)
    (= (x-of-put-down-lift-0010-solid-low-10 item-02) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-02) 9995) (= (z-of-put-down-lift-0010-solid-low-10 item-02) 7637)
    (can-lift-1001c-solid-low-10 item-02) (= (x-of-lift-1001c-solid-low-10 item-02) 10260) (= (y-of-lift-1001c-solid-low-10 item-02) 9493) (= (z-of-lift-1001c-solid-low-10 item-02) 11989) (= (cost-of-lift-1001c-solid-low-10 item-02) 11)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-02) 9998) (= (y-of-put-down-lift-1001c-solid-low-10 item-02) 9996) (= (z-of-put-down-lift-1001c-solid-low-10 item-02) 8011)
    (can-pull-0000b-solid-low-10 item-02) (= (x-of-pull-0000b-solid-low-10 item-02) 9384) (= (y-of-pull-0000b-solid-low-10 item-02) 9895) (= (cost-of-pull-0000b-solid-low-10 item-02) 14)
    (can-pull-0100-solid-low-10 item-02) (= (x-of-pull-0100-solid-low-10 item-02) 9144) (= (y-of-pull-0100-solid-low-10 item-02) 9991) (= (cost-of-pull-0100-solid-low-10 item-02) 7)
    (can-pull-0100c-solid-low-10 item-02) (= (x-of-pull-0100c-solid-low-10 item-02) 9398) (= (y-of-pull-0100c-solid-low-10 item-02) 10251) (= (cost-of-pull-0100c-solid-low-10 item-02) 11)
    (can-pull-0110c-solid-low-10 item-02) (= (x-of-pull-0110c-solid-low-10 item-02) 9478) (= (y-of-pull-0110c-solid-low-10 item-02) 9824) (= (cost-of-pull-0110c-solid-low-10 item-02) 4)
    (can-pull-left-1110c-solid-low-10 item-02) (= (x-of-pull-left-1110c-solid-low-10 item-02) 9619) (= (y-of-pull-left-1110c-solid-low-10 item-02) 10361) (= (cost-of-pull-left-1110c-solid-low-10 item-02) 4)
    (can-push-forward-0101c-solid-low-10 item-02) (= (x-of-push-forward-0101c-solid-low-10 item-02) 10529) (= (y-of-push-forward-0101c-solid-low-10 item-02) 9827) (= (cost-of-push-forward-0101c-solid-low-10 item-02) 14)
    (can-push-forward-1011-solid-low-10 item-02) (= (x-of-push-forward-1011-solid-low-10 item-02) 10837) (= (y-of-push-forward-1011-solid-low-10 item-02) 10103) (= (cost-of-push-forward-1011-solid-low-10 item-02) 4)
    (= (x-of-push-forward-left-1001c-solid-low-10 item-02) 10392) (= (y-of-push-forward-left-1001c-solid-low-10 item-02) 10486) (= (cost-of-push-forward-left-1001c-solid-low-10 item-02) 241)
    (can-push-forward-left-1010-solid-low-10 item-02) (= (x-of-push-forward-left-1010-solid-low-10 item-02) 10076) (= (y-of-push-forward-left-1010-solid-low-10 item-02) 10142) (= (cost-of-push-forward-left-1010-solid-low-10 item-02) 14)
    (can-push-forward-left-1100c-solid-low-10 item-02) (= (x-of-push-forward-left-1100c-solid-low-10 item-02) 9992) (= (y-of-push-forward-left-1100c-solid-low-10 item-02) 9768) (= (cost-of-push-forward-left-1100c-solid-low-10 item-02) 4)
    (= (x-of-push-forward-right-0111c-solid-low-10 item-02) 10168) (= (y-of-push-forward-right-0111c-solid-low-10 item-02) 9894) (= (cost-of-push-forward-right-0111c-solid-low-10 item-02) 7)
    (= (x-of-push-forward-right-1111-solid-low-10 item-02) 10319) (= (y-of-push-forward-right-1111-solid-low-10 item-02) 10006) (= (cost-of-push-forward-right-1111-solid-low-10 item-02) 33)
    (= (x-of-push-left-1000-solid-low-10 item-02) 9984) (= (y-of-push-left-1000-solid-low-10 item-02) 10044) (= (cost-of-push-left-1000-solid-low-10 item-02) 25)
    (can-push-right-0001b-solid-low-10 item-02) (= (x-of-push-right-0001b-solid-low-10 item-02) 9920) (= (y-of-push-right-0001b-solid-low-10 item-02) 9634) (= (cost-of-push-right-0001b-solid-low-10 item-02) 11)
    (= (x-of-push-right-0010-solid-low-10 item-02) 10084) (= (y-of-push-right-0010-solid-low-10 item-02) 9793) (= (cost-of-push-right-0010-solid-low-10 item-02) 21)
    (can-push-right-0011-solid-low-10 item-02) (= (x-of-push-right-0011-solid-low-10 item-02) 10142) (= (y-of-push-right-0011-solid-low-10 item-02) 9641) (= (cost-of-push-right-0011-solid-low-10 item-02) 11)
    (= (x-of-stay-1101-solid-low-10 item-02) 10004) (= (y-of-stay-1101-solid-low-10 item-02) 10059) (= (cost-of-stay-1101-solid-low-10 item-02) 11)
    ; item-03 starts at (0.6974, -0.0370, 0.0190) m
    (= (x item-03) 3474) (= (y item-03) 2630) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.131 0.131 0.03805 2).
    ; Not for item-03:
    ; lift-0000-hollow-wide-00: keeps its promise with such objects in about 5 of 30 only.
    ; lift-0010a-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; lift-0011-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    (= (x-of-lift-0000-hollow-wide-00 item-03) 9359) (= (y-of-lift-0000-hollow-wide-00 item-03) 9549) (= (z-of-lift-0000-hollow-wide-00 item-03) 12070) (= (cost-of-lift-0000-hollow-wide-00 item-03) 168)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-03) 9913) (= (y-of-put-down-lift-0000-hollow-wide-00 item-03) 10179) (= (z-of-put-down-lift-0000-hollow-wide-00 item-03) 7930)
    (can-lift-0001-hollow-wide-00 item-03) (= (x-of-lift-0001-hollow-wide-00 item-03) 9654) (= (y-of-lift-0001-hollow-wide-00 item-03) 9143) (= (z-of-lift-0001-hollow-wide-00 item-03) 12442) (= (cost-of-lift-0001-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-03) 9996) (= (y-of-put-down-lift-0001-hollow-wide-00 item-03) 9959) (= (z-of-put-down-lift-0001-hollow-wide-00 item-03) 7558)
    (= (x-of-lift-0010a-hollow-wide-00 item-03) 9997) (= (y-of-lift-0010a-hollow-wide-00 item-03) 9678) (= (z-of-lift-0010a-hollow-wide-00 item-03) 11992) (= (cost-of-lift-0010a-hollow-wide-00 item-03) 209)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-03) 10000) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-03) 9956) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-03) 8008)
    (= (x-of-lift-0011-hollow-wide-00 item-03) 10342) (= (y-of-lift-0011-hollow-wide-00 item-03) 8881) (= (z-of-lift-0011-hollow-wide-00 item-03) 11966) (= (cost-of-lift-0011-hollow-wide-00 item-03) 153)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-03) 9997) (= (y-of-put-down-lift-0011-hollow-wide-00 item-03) 9962) (= (z-of-put-down-lift-0011-hollow-wide-00 item-03) 8034)
    (can-lift-0011a-hollow-wide-00 item-03) (= (x-of-lift-0011a-hollow-wide-00 item-03) 10478) (= (y-of-lift-0011a-hollow-wide-00 item-03) 9293) (= (z-of-lift-0011a-hollow-wide-00 item-03) 12417) (= (cost-of-lift-0011a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-03) 9997) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-03) 9955) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-03) 7583)
    (can-lift-1000-hollow-wide-00 item-03) (= (x-of-lift-1000-hollow-wide-00 item-03) 9721) (= (y-of-lift-1000-hollow-wide-00 item-03) 11006) (= (z-of-lift-1000-hollow-wide-00 item-03) 12118) (= (cost-of-lift-1000-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-03) 10012) (= (y-of-put-down-lift-1000-hollow-wide-00 item-03) 9970) (= (z-of-put-down-lift-1000-hollow-wide-00 item-03) 7882)
    (can-lift-1000a-hollow-wide-00 item-03) (= (x-of-lift-1000a-hollow-wide-00 item-03) 9581) (= (y-of-lift-1000a-hollow-wide-00 item-03) 10352) (= (z-of-lift-1000a-hollow-wide-00 item-03) 12378) (= (cost-of-lift-1000a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-03) 9997) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-03) 9963) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-03) 7622)
    (can-lift-1001a-hollow-wide-00 item-03) (= (x-of-lift-1001a-hollow-wide-00 item-03) 10205) (= (y-of-lift-1001a-hollow-wide-00 item-03) 10213) (= (z-of-lift-1001a-hollow-wide-00 item-03) 12149) (= (cost-of-lift-1001a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-03) 9996) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-03) 9963) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-03) 7851)
    (can-lift-1010a-hollow-wide-00 item-03) (= (x-of-lift-1010a-hollow-wide-00 item-03) 10280) (= (y-of-lift-1010a-hollow-wide-00 item-03) 10925) (= (z-of-lift-1010a-hollow-wide-00 item-03) 11976) (= (cost-of-lift-1010a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-03) 9998) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-03) 9977) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-03) 8024)
    (= (x-of-lift-1101-hollow-wide-00 item-03) 10285) (= (y-of-lift-1101-hollow-wide-00 item-03) 10156) (= (z-of-lift-1101-hollow-wide-00 item-03) 12009) (= (cost-of-lift-1101-hollow-wide-00 item-03) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-03) 10017) (= (y-of-put-down-lift-1101-hollow-wide-00 item-03) 10011) (= (z-of-put-down-lift-1101-hollow-wide-00 item-03) 7991)
    (can-place-back-right-0000-hollow-wide-00 item-03) (= (x-of-place-back-right-0000-hollow-wide-00 item-03) 9063) (= (y-of-place-back-right-0000-hollow-wide-00 item-03) 9755) (= (cost-of-place-back-right-0000-hollow-wide-00 item-03) 91)
    (can-place-right-0111-hollow-wide-00 item-03) (= (x-of-place-right-0111-hollow-wide-00 item-03) 9675) (= (y-of-place-right-0111-hollow-wide-00 item-03) 9104) (= (cost-of-place-right-0111-hollow-wide-00 item-03) 11)
    (can-place-right-0111a-hollow-wide-00 item-03) (= (x-of-place-right-0111a-hollow-wide-00 item-03) 10181) (= (y-of-place-right-0111a-hollow-wide-00 item-03) 9083) (= (cost-of-place-right-0111a-hollow-wide-00 item-03) 4)
    (can-pull-0100-hollow-wide-00 item-03) (= (x-of-pull-0100-hollow-wide-00 item-03) 8883) (= (y-of-pull-0100-hollow-wide-00 item-03) 9804) (= (cost-of-pull-0100-hollow-wide-00 item-03) 11)
    (can-pull-left-0110a-hollow-wide-00 item-03) (= (x-of-pull-left-0110a-hollow-wide-00 item-03) 9714) (= (y-of-pull-left-0110a-hollow-wide-00 item-03) 10230) (= (cost-of-pull-left-0110a-hollow-wide-00 item-03) 4)
    (can-pull-right-0100a-hollow-wide-00 item-03) (= (x-of-pull-right-0100a-hollow-wide-00 item-03) 9651) (= (y-of-pull-right-0100a-hollow-wide-00 item-03) 9689) (= (cost-of-pull-right-0100a-hollow-wide-00 item-03) 4)
    (can-pull-right-0110-hollow-wide-00 item-03) (= (x-of-pull-right-0110-hollow-wide-00 item-03) 9807) (= (y-of-pull-right-0110-hollow-wide-00 item-03) 9978) (= (cost-of-pull-right-0110-hollow-wide-00 item-03) 4)
    (can-push-forward-1011a-hollow-wide-00 item-03) (= (x-of-push-forward-1011a-hollow-wide-00 item-03) 11184) (= (y-of-push-forward-1011a-hollow-wide-00 item-03) 10065) (= (cost-of-push-forward-1011a-hollow-wide-00 item-03) 11)
    (can-push-forward-1110a-hollow-wide-00 item-03) (= (x-of-push-forward-1110a-hollow-wide-00 item-03) 10301) (= (y-of-push-forward-1110a-hollow-wide-00 item-03) 9910) (= (cost-of-push-forward-1110a-hollow-wide-00 item-03) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-03) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-03) 10289) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-03) 10443) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-03) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-03) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-03) 10387) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-03) 9630) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-03) 4)
    (can-push-left-1100a-hollow-wide-00 item-03) (= (x-of-push-left-1100a-hollow-wide-00 item-03) 9817) (= (y-of-push-left-1100a-hollow-wide-00 item-03) 10653) (= (cost-of-push-left-1100a-hollow-wide-00 item-03) 14)
    (can-push-right-0010a-hollow-wide-00 item-03) (= (x-of-push-right-0010a-hollow-wide-00 item-03) 9949) (= (y-of-push-right-0010a-hollow-wide-00 item-03) 9712) (= (cost-of-push-right-0010a-hollow-wide-00 item-03) 14)
    (can-push-right-0011-hollow-wide-00 item-03) (= (x-of-push-right-0011-hollow-wide-00 item-03) 10076) (= (y-of-push-right-0011-hollow-wide-00 item-03) 9569) (= (cost-of-push-right-0011-hollow-wide-00 item-03) 30)
    (can-push-right-1101-hollow-wide-00 item-03) (= (x-of-push-right-1101-hollow-wide-00 item-03) 10102) (= (y-of-push-right-1101-hollow-wide-00 item-03) 9868) (= (cost-of-push-right-1101-hollow-wide-00 item-03) 4)
    ; item-04 starts at (0.8568, -0.0877, 0.0152) m
    (= (x item-04) 5068) (= (y item-04) 2123) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1783 0.1783 0.03038 2).
    ; Not for item-04:
    ; lift-0000-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; lift-0010a-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; lift-0011-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    ; push-forward-1011a-hollow-wide-00: scatters more than it moves.
    (= (x-of-lift-0000-hollow-wide-00 item-04) 9356) (= (y-of-lift-0000-hollow-wide-00 item-04) 9247) (= (z-of-lift-0000-hollow-wide-00 item-04) 12049) (= (cost-of-lift-0000-hollow-wide-00 item-04) 278)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-04) 9983) (= (y-of-put-down-lift-0000-hollow-wide-00 item-04) 9981) (= (z-of-put-down-lift-0000-hollow-wide-00 item-04) 7951)
    (can-lift-0001-hollow-wide-00 item-04) (= (x-of-lift-0001-hollow-wide-00 item-04) 9645) (= (y-of-lift-0001-hollow-wide-00 item-04) 8917) (= (z-of-lift-0001-hollow-wide-00 item-04) 12348) (= (cost-of-lift-0001-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-04) 9996) (= (y-of-put-down-lift-0001-hollow-wide-00 item-04) 9958) (= (z-of-put-down-lift-0001-hollow-wide-00 item-04) 7652)
    (= (x-of-lift-0010a-hollow-wide-00 item-04) 10078) (= (y-of-lift-0010a-hollow-wide-00 item-04) 9639) (= (z-of-lift-0010a-hollow-wide-00 item-04) 11860) (= (cost-of-lift-0010a-hollow-wide-00 item-04) 209)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-04) 9995) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-04) 9982) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-04) 8140)
    (= (x-of-lift-0011-hollow-wide-00 item-04) 10262) (= (y-of-lift-0011-hollow-wide-00 item-04) 8680) (= (z-of-lift-0011-hollow-wide-00 item-04) 11889) (= (cost-of-lift-0011-hollow-wide-00 item-04) 209)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-04) 10004) (= (y-of-put-down-lift-0011-hollow-wide-00 item-04) 9964) (= (z-of-put-down-lift-0011-hollow-wide-00 item-04) 8111)
    (can-lift-0011a-hollow-wide-00 item-04) (= (x-of-lift-0011a-hollow-wide-00 item-04) 10494) (= (y-of-lift-0011a-hollow-wide-00 item-04) 9071) (= (z-of-lift-0011a-hollow-wide-00 item-04) 12298) (= (cost-of-lift-0011a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-04) 10003) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-04) 9966) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-04) 7702)
    (can-lift-1000-hollow-wide-00 item-04) (= (x-of-lift-1000-hollow-wide-00 item-04) 9739) (= (y-of-lift-1000-hollow-wide-00 item-04) 11200) (= (z-of-lift-1000-hollow-wide-00 item-04) 11967) (= (cost-of-lift-1000-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-04) 10001) (= (y-of-put-down-lift-1000-hollow-wide-00 item-04) 9972) (= (z-of-put-down-lift-1000-hollow-wide-00 item-04) 8033)
    (can-lift-1000a-hollow-wide-00 item-04) (= (x-of-lift-1000a-hollow-wide-00 item-04) 9585) (= (y-of-lift-1000a-hollow-wide-00 item-04) 10577) (= (z-of-lift-1000a-hollow-wide-00 item-04) 12334) (= (cost-of-lift-1000a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-04) 9993) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-04) 9956) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-04) 7666)
    (can-lift-1001a-hollow-wide-00 item-04) (= (x-of-lift-1001a-hollow-wide-00 item-04) 10220) (= (y-of-lift-1001a-hollow-wide-00 item-04) 10428) (= (z-of-lift-1001a-hollow-wide-00 item-04) 12094) (= (cost-of-lift-1001a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-04) 9998) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-04) 9973) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-04) 7906)
    (can-lift-1010a-hollow-wide-00 item-04) (= (x-of-lift-1010a-hollow-wide-00 item-04) 10285) (= (y-of-lift-1010a-hollow-wide-00 item-04) 11113) (= (z-of-lift-1010a-hollow-wide-00 item-04) 11963) (= (cost-of-lift-1010a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-04) 10001) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-04) 9971) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-04) 8037)
    (= (x-of-lift-1101-hollow-wide-00 item-04) 10253) (= (y-of-lift-1101-hollow-wide-00 item-04) 10148) (= (z-of-lift-1101-hollow-wide-00 item-04) 11999) (= (cost-of-lift-1101-hollow-wide-00 item-04) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-04) 9999) (= (y-of-put-down-lift-1101-hollow-wide-00 item-04) 10008) (= (z-of-put-down-lift-1101-hollow-wide-00 item-04) 8001)
    (can-place-back-right-0000-hollow-wide-00 item-04) (= (x-of-place-back-right-0000-hollow-wide-00 item-04) 9418) (= (y-of-place-back-right-0000-hollow-wide-00 item-04) 9440) (= (cost-of-place-back-right-0000-hollow-wide-00 item-04) 34)
    (can-place-right-0111-hollow-wide-00 item-04) (= (x-of-place-right-0111-hollow-wide-00 item-04) 9593) (= (y-of-place-right-0111-hollow-wide-00 item-04) 8806) (= (cost-of-place-right-0111-hollow-wide-00 item-04) 4)
    (can-place-right-0111a-hollow-wide-00 item-04) (= (x-of-place-right-0111a-hollow-wide-00 item-04) 10245) (= (y-of-place-right-0111a-hollow-wide-00 item-04) 8861) (= (cost-of-place-right-0111a-hollow-wide-00 item-04) 4)
    (can-pull-0100-hollow-wide-00 item-04) (= (x-of-pull-0100-hollow-wide-00 item-04) 9715) (= (y-of-pull-0100-hollow-wide-00 item-04) 9970) (= (cost-of-pull-0100-hollow-wide-00 item-04) 11)
    (can-pull-left-0110a-hollow-wide-00 item-04) (= (x-of-pull-left-0110a-hollow-wide-00 item-04) 9751) (= (y-of-pull-left-0110a-hollow-wide-00 item-04) 10207) (= (cost-of-pull-left-0110a-hollow-wide-00 item-04) 4)
    (can-pull-right-0100a-hollow-wide-00 item-04) (= (x-of-pull-right-0100a-hollow-wide-00 item-04) 9722) (= (y-of-pull-right-0100a-hollow-wide-00 item-04) 9701) (= (cost-of-pull-right-0100a-hollow-wide-00 item-04) 4)
    (can-pull-right-0110-hollow-wide-00 item-04) (= (x-of-pull-right-0110-hollow-wide-00 item-04) 9867) (= (y-of-pull-right-0110-hollow-wide-00 item-04) 9580) (= (cost-of-pull-right-0110-hollow-wide-00 item-04) 4)
    (= (x-of-push-forward-1011a-hollow-wide-00 item-04) 10191) (= (y-of-push-forward-1011a-hollow-wide-00 item-04) 9989) (= (cost-of-push-forward-1011a-hollow-wide-00 item-04) 11)
    (can-push-forward-1110a-hollow-wide-00 item-04) (= (x-of-push-forward-1110a-hollow-wide-00 item-04) 10320) (= (y-of-push-forward-1110a-hollow-wide-00 item-04) 9910) (= (cost-of-push-forward-1110a-hollow-wide-00 item-04) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-04) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-04) 10313) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-04) 10488) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-04) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-04) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-04) 10444) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-04) 9504) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-04) 4)
    (can-push-left-1100a-hollow-wide-00 item-04) (= (x-of-push-left-1100a-hollow-wide-00 item-04) 9617) (= (y-of-push-left-1100a-hollow-wide-00 item-04) 10997) (= (cost-of-push-left-1100a-hollow-wide-00 item-04) 4)
    (can-push-right-0010a-hollow-wide-00 item-04) (= (x-of-push-right-0010a-hollow-wide-00 item-04) 9937) (= (y-of-push-right-0010a-hollow-wide-00 item-04) 9398) (= (cost-of-push-right-0010a-hollow-wide-00 item-04) 14)
    (can-push-right-0011-hollow-wide-00 item-04) (= (x-of-push-right-0011-hollow-wide-00 item-04) 10045) (= (y-of-push-right-0011-hollow-wide-00 item-04) 9473) (= (cost-of-push-right-0011-hollow-wide-00 item-04) 14)
    (can-push-right-1101-hollow-wide-00 item-04) (= (x-of-push-right-1101-hollow-wide-00 item-04) 10011) (= (y-of-push-right-1101-hollow-wide-00 item-04) 9499) (= (cost-of-push-right-1101-hollow-wide-00 item-04) 7))
  (:goal (and
    ; item-01 shall come to (0.9112, 0.1574, 0.0142) m, 336 mm from where it starts
    (<= (x item-01) 6067) (>= (x item-01) 5157)
    (<= (+ (x item-01) (y item-01)) 10830) (>= (+ (x item-01) (y item-01)) 9543)
    (<= (y item-01) 5029) (>= (y item-01) 4119)
    (<= (+ (y item-01) 395) (x item-01)) (<= (x item-01) (+ (y item-01) 1682))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7536, 0.1250, 0.0236) m, 221 mm from where it starts
    (<= (x item-02) 4491) (>= (x item-02) 3582)
    (<= (+ (x item-02) (y item-02)) 8930) (>= (+ (x item-02) (y item-02)) 7643)
    (<= (y item-02) 4705) (>= (y item-02) 3795)
    (<= (y item-02) (+ (x item-02) 857)) (<= (x item-02) (+ (y item-02) 430))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6539, -0.2028, 0.0190) m, 171 mm from where it starts
    (<= (x item-03) 3494) (>= (x item-03) 2584)
    (<= (+ (x item-03) (y item-03)) 4655) (>= (+ (x item-03) (y item-03)) 3368)
    (<= (y item-03) 1427) (>= (y item-03) 518)
    (<= (+ (y item-03) 1423) (x item-03)) (<= (x item-03) (+ (y item-03) 2710))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.5849, -0.0385, 0.0152) m, 276 mm from where it starts
    (<= (x item-04) 2804) (>= (x item-04) 1894)
    (<= (+ (x item-04) (y item-04)) 5608) (>= (+ (x item-04) (y item-04)) 4321)
    (<= (y item-04) 3070) (>= (y item-04) 2160)
    (<= (y item-04) (+ (x item-04) 910)) (<= (x item-04) (+ (y item-04) 377))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
