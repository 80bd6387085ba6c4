; Problem anywhere-3-08 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 9; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-3-08)
  (:domain places-numeric)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - hollow-wide-00
    item-03 - solid-low-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5965, 0.0193, 0.0124) m
    (= (x item-01) 2465) (= (y item-01) 3193) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.09542 0.1158 0.0248 1).
    ; Not for item-01:
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0001a-any-tall-narrow-11: scatters more than it moves.
    (can-lift-0000c-any-tall-narrow-11 item-01) (= (x-of-lift-0000c-any-tall-narrow-11 item-01) 9444) (= (y-of-lift-0000c-any-tall-narrow-11 item-01) 10478) (= (z-of-lift-0000c-any-tall-narrow-11 item-01) 11995) (= (cost-of-lift-0000c-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 9994) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 8005)
    (can-lift-0001-any-tall-narrow-11 item-01) (= (x-of-lift-0001-any-tall-narrow-11 item-01) 9684) (= (y-of-lift-0001-any-tall-narrow-11 item-01) 9231) (= (z-of-lift-0001-any-tall-narrow-11 item-01) 12292) (= (cost-of-lift-0001-any-tall-narrow-11 item-01) 11)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9998) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9950) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-01) 7708)
    (can-lift-0001a-any-tall-narrow-11 item-01) (= (x-of-lift-0001a-any-tall-narrow-11 item-01) 9805) (= (y-of-lift-0001a-any-tall-narrow-11 item-01) 9761) (= (z-of-lift-0001a-any-tall-narrow-11 item-01) 12002) (= (cost-of-lift-0001a-any-tall-narrow-11 item-01) 117)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 10000) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 9988) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 7998)
    (can-lift-0010b-any-tall-narrow-11 item-01) (= (x-of-lift-0010b-any-tall-narrow-11 item-01) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-01) 10233) (= (z-of-lift-0010b-any-tall-narrow-11 item-01) 12314) (= (cost-of-lift-0010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 9992) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 7686)
    (can-lift-0011-any-tall-narrow-11 item-01) (= (x-of-lift-0011-any-tall-narrow-11 item-01) 10379) (= (y-of-lift-0011-any-tall-narrow-11 item-01) 9268) (= (z-of-lift-0011-any-tall-narrow-11 item-01) 11997) (= (cost-of-lift-0011-any-tall-narrow-11 item-01) 70)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-01) 9981) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-01) 8003)
    (can-lift-0011c-any-tall-narrow-11 item-01) (= (x-of-lift-0011c-any-tall-narrow-11 item-01) 9852) (= (y-of-lift-0011c-any-tall-narrow-11 item-01) 9677) (= (z-of-lift-0011c-any-tall-narrow-11 item-01) 12475) (= (cost-of-lift-0011c-any-tall-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 10005) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 9987) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 7525)
    (can-lift-1000-any-tall-narrow-11 item-01) (= (x-of-lift-1000-any-tall-narrow-11 item-01) 9735) (= (y-of-lift-1000-any-tall-narrow-11 item-01) 10431) (= (z-of-lift-1000-any-tall-narrow-11 item-01) 12310) (= (cost-of-lift-1000-any-tall-narrow-11 item-01) 11)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-01) 10007) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-01) 9991) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-01) 7690)
    (can-lift-1001d-any-tall-narrow-11 item-01) (= (x-of-lift-1001d-any-tall-narrow-11 item-01) 10606) (= (y-of-lift-1001d-any-tall-narrow-11 item-01) 9546) (= (z-of-lift-1001d-any-tall-narrow-11 item-01) 12019) (= (cost-of-lift-1001d-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 9994) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 9992) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 7981)
    (can-lift-1010b-any-tall-narrow-11 item-01) (= (x-of-lift-1010b-any-tall-narrow-11 item-01) 10278) (= (y-of-lift-1010b-any-tall-narrow-11 item-01) 10226) (= (z-of-lift-1010b-any-tall-narrow-11 item-01) 12003) (= (cost-of-lift-1010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 10003) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 9992) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 7997)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-01) 10283) (= (y-of-lift-1101a-any-tall-narrow-11 item-01) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-01) 12037) (= (cost-of-lift-1101a-any-tall-narrow-11 item-01) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10040) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10027) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 7963)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-01) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 10322) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 9526) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 4)
    (can-pull-0100-any-tall-narrow-11 item-01) (= (x-of-pull-0100-any-tall-narrow-11 item-01) 9085) (= (y-of-pull-0100-any-tall-narrow-11 item-01) 9784) (= (cost-of-pull-0100-any-tall-narrow-11 item-01) 4)
    (can-pull-0110d-any-tall-narrow-11 item-01) (= (x-of-pull-0110d-any-tall-narrow-11 item-01) 9713) (= (y-of-pull-0110d-any-tall-narrow-11 item-01) 9933) (= (cost-of-pull-0110d-any-tall-narrow-11 item-01) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-01) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-01) 9840) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-01) 10175) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-01) 11)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-01) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-01) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-01) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-01) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-01) 9421) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-01) 9724) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011-any-tall-narrow-11 item-01) 11066) (= (y-of-push-forward-1011-any-tall-narrow-11 item-01) 10239) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-01) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-01) 10828) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-01) 10060) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-01) 10412) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-01) 10008) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-01) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10159) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10263) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-01) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-01) 10462) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-01) 9508) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-01) 14)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-01) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-01) 10103) (= (cost-of-push-left-1000-any-tall-narrow-11 item-01) 238)
    (can-push-left-1101a-any-tall-narrow-11 item-01) (= (x-of-push-left-1101a-any-tall-narrow-11 item-01) 9927) (= (y-of-push-left-1101a-any-tall-narrow-11 item-01) 10194) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-01) 7)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-01) 9894) (= (y-of-push-right-0001-any-tall-narrow-11 item-01) 9816) (= (cost-of-push-right-0001-any-tall-narrow-11 item-01) 278)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-01) 9980) (= (y-of-push-right-0001a-any-tall-narrow-11 item-01) 9887) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-01) 77)
    (can-push-right-0011-any-tall-narrow-11 item-01) (= (x-of-push-right-0011-any-tall-narrow-11 item-01) 10102) (= (y-of-push-right-0011-any-tall-narrow-11 item-01) 9785) (= (cost-of-push-right-0011-any-tall-narrow-11 item-01) 99)
    (can-push-right-0101d-any-tall-narrow-11 item-01) (= (x-of-push-right-0101d-any-tall-narrow-11 item-01) 9999) (= (y-of-push-right-0101d-any-tall-narrow-11 item-01) 9526) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-01) 11)
    (can-push-right-0111-any-tall-narrow-11 item-01) (= (x-of-push-right-0111-any-tall-narrow-11 item-01) 9778) (= (y-of-push-right-0111-any-tall-narrow-11 item-01) 9253) (= (cost-of-push-right-0111-any-tall-narrow-11 item-01) 30)
    ; item-02 starts at (0.6199, -0.2108, 0.0211) m
    (= (x item-02) 2699) (= (y item-02) 892) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1496 0.1496 0.04217 2).
    ; Not for item-02:
    ; lift-0000-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; lift-0011-hollow-wide-00: keeps its promise with such objects in about 5 of 30 only.
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    ; push-right-0010a-hollow-wide-00: scatters more than it moves.
    (= (x-of-lift-0000-hollow-wide-00 item-02) 9627) (= (y-of-lift-0000-hollow-wide-00 item-02) 9316) (= (z-of-lift-0000-hollow-wide-00 item-02) 11781) (= (cost-of-lift-0000-hollow-wide-00 item-02) 278)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-02) 9913) (= (y-of-put-down-lift-0000-hollow-wide-00 item-02) 10078) (= (z-of-put-down-lift-0000-hollow-wide-00 item-02) 8219)
    (can-lift-0001-hollow-wide-00 item-02) (= (x-of-lift-0001-hollow-wide-00 item-02) 9651) (= (y-of-lift-0001-hollow-wide-00 item-02) 9052) (= (z-of-lift-0001-hollow-wide-00 item-02) 12444) (= (cost-of-lift-0001-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-02) 10000) (= (y-of-put-down-lift-0001-hollow-wide-00 item-02) 9963) (= (z-of-put-down-lift-0001-hollow-wide-00 item-02) 7556)
    (can-lift-0010a-hollow-wide-00 item-02) (= (x-of-lift-0010a-hollow-wide-00 item-02) 10034) (= (y-of-lift-0010a-hollow-wide-00 item-02) 9664) (= (z-of-lift-0010a-hollow-wide-00 item-02) 11973) (= (cost-of-lift-0010a-hollow-wide-00 item-02) 108)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-02) 9999) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-02) 9963) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-02) 8027)
    (= (x-of-lift-0011-hollow-wide-00 item-02) 10309) (= (y-of-lift-0011-hollow-wide-00 item-02) 8780) (= (z-of-lift-0011-hollow-wide-00 item-02) 11969) (= (cost-of-lift-0011-hollow-wide-00 item-02) 168)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-02) 9999) (= (y-of-put-down-lift-0011-hollow-wide-00 item-02) 9969) (= (z-of-put-down-lift-0011-hollow-wide-00 item-02) 8031)
    (can-lift-0011a-hollow-wide-00 item-02) (= (x-of-lift-0011a-hollow-wide-00 item-02) 10491) (= (y-of-lift-0011a-hollow-wide-00 item-02) 9204) (= (z-of-lift-0011a-hollow-wide-00 item-02) 12425) (= (cost-of-lift-0011a-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-02) 9995) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-02) 9962) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-02) 7575)
    (can-lift-1000-hollow-wide-00 item-02) (= (x-of-lift-1000-hollow-wide-00 item-02) 9691) (= (y-of-lift-1000-hollow-wide-00 item-02) 11113) (= (z-of-lift-1000-hollow-wide-00 item-02) 12016) (= (cost-of-lift-1000-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-02) 10003) (= (y-of-put-down-lift-1000-hollow-wide-00 item-02) 9974) (= (z-of-put-down-lift-1000-hollow-wide-00 item-02) 7984)
    (can-lift-1000a-hollow-wide-00 item-02) (= (x-of-lift-1000a-hollow-wide-00 item-02) 9585) (= (y-of-lift-1000a-hollow-wide-00 item-02) 10445) (= (z-of-lift-1000a-hollow-wide-00 item-02) 12401) (= (cost-of-lift-1000a-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-02) 9998) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-02) 9963) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-02) 7599)
    (can-lift-1001a-hollow-wide-00 item-02) (= (x-of-lift-1001a-hollow-wide-00 item-02) 10170) (= (y-of-lift-1001a-hollow-wide-00 item-02) 10305) (= (z-of-lift-1001a-hollow-wide-00 item-02) 12144) (= (cost-of-lift-1001a-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-02) 10000) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-02) 9967) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-02) 7856)
    (can-lift-1010a-hollow-wide-00 item-02) (= (x-of-lift-1010a-hollow-wide-00 item-02) 10275) (= (y-of-lift-1010a-hollow-wide-00 item-02) 11010) (= (z-of-lift-1010a-hollow-wide-00 item-02) 11981) (= (cost-of-lift-1010a-hollow-wide-00 item-02) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-02) 9999) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-02) 9975) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-02) 8019)
    (= (x-of-lift-1101-hollow-wide-00 item-02) 10313) (= (y-of-lift-1101-hollow-wide-00 item-02) 10154) (= (z-of-lift-1101-hollow-wide-00 item-02) 12001) (= (cost-of-lift-1101-hollow-wide-00 item-02) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-02) 10003) (= (y-of-put-down-lift-1101-hollow-wide-00 item-02) 10010) (= (z-of-put-down-lift-1101-hollow-wide-00 item-02) 7999)
    (can-place-back-right-0000-hollow-wide-00 item-02) (= (x-of-place-back-right-0000-hollow-wide-00 item-02) 9488) (= (y-of-place-back-right-0000-hollow-wide-00 item-02) 9514) (= (cost-of-place-back-right-0000-hollow-wide-00 item-02) 91)
    (can-place-right-0111-hollow-wide-00 item-02) (= (x-of-place-right-0111-hollow-wide-00 item-02) 9611) (= (y-of-place-right-0111-hollow-wide-00 item-02) 8952) (= (cost-of-place-right-0111-hollow-wide-00 item-02) 7)
    (can-place-right-0111a-hollow-wide-00 item-02) (= (x-of-place-right-0111a-hollow-wide-00 item-02) 10200) (= (y-of-place-right-0111a-hollow-wide-00 item-02) 8995) (= (cost-of-place-right-0111a-hollow-wide-00 item-02) 4)
    (can-pull-0100-hollow-wide-00 item-02) (= (x-of-pull-0100-hollow-wide-00 item-02) 9126) (= (y-of-pull-0100-hollow-wide-00 item-02) 9856) (= (cost-of-pull-0100-hollow-wide-00 item-02) 11)
    (can-pull-left-0110a-hollow-wide-00 item-02) (= (x-of-pull-left-0110a-hollow-wide-00 item-02) 9700) (= (y-of-pull-left-0110a-hollow-wide-00 item-02) 10258) (= (cost-of-pull-left-0110a-hollow-wide-00 item-02) 4)
    (can-pull-right-0100a-hollow-wide-00 item-02) (= (x-of-pull-right-0100a-hollow-wide-00 item-02) 9637) (= (y-of-pull-right-0100a-hollow-wide-00 item-02) 9682) (= (cost-of-pull-right-0100a-hollow-wide-00 item-02) 4)
    (can-pull-right-0110-hollow-wide-00 item-02) (= (x-of-pull-right-0110-hollow-wide-00 item-02) 9771) (= (y-of-pull-right-0110-hollow-wide-00 item-02) 10027) (= (cost-of-pull-right-0110-hollow-wide-00 item-02) 4)
    (can-push-forward-1011a-hollow-wide-00 item-02) (= (x-of-push-forward-1011a-hollow-wide-00 item-02) 11014) (= (y-of-push-forward-1011a-hollow-wide-00 item-02) 10035) (= (cost-of-push-forward-1011a-hollow-wide-00 item-02) 11)
    (can-push-forward-1110a-hollow-wide-00 item-02) (= (x-of-push-forward-1110a-hollow-wide-00 item-02) 10309) (= (y-of-push-forward-1110a-hollow-wide-00 item-02) 9911) (= (cost-of-push-forward-1110a-hollow-wide-00 item-02) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-02) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-02) 10302) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-02) 10458) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-02) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-02) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-02) 10410) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-02) 9604) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-02) 4)
    (can-push-left-1100a-hollow-wide-00 item-02) (= (x-of-push-left-1100a-hollow-wide-00 item-02) 9699) (= (y-of-push-left-1100a-hollow-wide-00 item-02) 10838) (= (cost-of-push-left-1100a-hollow-wide-00 item-02) 7)
    (= (x-of-push-right-0010a-hollow-wide-00 item-02) 9974) (= (y-of-push-right-0010a-hollow-wide-00 item-02) 9770) (= (cost-of-push-right-0010a-hollow-wide-00 item-02) 43)
    (can-push-right-0011-hollow-wide-00 item-02) (= (x-of-push-right-0011-hollow-wide-00 item-02) 10041) (= (y-of-push-right-0011-hollow-wide-00 item-02) 9579) (= (cost-of-push-right-0011-hollow-wide-00 item-02) 22)
    (can-push-right-1101-hollow-wide-00 item-02) (= (x-of-push-right-1101-hollow-wide-00 item-02) 10012) (= (y-of-push-right-1101-hollow-wide-00 item-02) 9765) (= (cost-of-push-right-1101-hollow-wide-00 item-02) 4)
    ; item-03 starts at (0.4937, -0.0160, 0.0321) m
    (= (x item-03) 1437) (= (y item-03) 2840) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.05207 0.1773 0.06412 1).
    ; Not for item-03:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-03) 10273) (= (y-of-lift-0010-solid-low-10 item-03) 10235) (= (z-of-lift-0010-solid-low-10 item-03) 12333) (= (cost-of-lift-0010-solid-low-10 item-03) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-03) 10002) (= (y-of-put-down-lift-0010-solid-low-10 item-03) 9994) (= (z-of-put-down-lift-0010-solid-low-10 item-03) 7667)
    (= (x-of-lift-1001c-solid-low-10 item-03) 10077) (= (y-of-lift-1001c-solid-low-10 item-03) 9584) (= (z-of-lift-1001c-solid-low-10 item-03) 11998) (= (cost-of-lift-1001c-solid-low-10 item-03) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-03) 10000) (= (y-of-put-down-lift-1001c-solid-low-10 item-03) 9973) (= (z-of-put-down-lift-1001c-solid-low-10 item-03) 8002)
    (can-pull-0000b-solid-low-10 item-03) (= (x-of-pull-0000b-solid-low-10 item-03) 9564) (= (y-of-pull-0000b-solid-low-10 item-03) 9865) (= (cost-of-pull-0000b-solid-low-10 item-03) 14)
    (can-pull-0100-solid-low-10 item-03) (= (x-of-pull-0100-solid-low-10 item-03) 9281) (= (y-of-pull-0100-solid-low-10 item-03) 9960) (= (cost-of-pull-0100-solid-low-10 item-03) 7)
    (can-pull-0100c-solid-low-10 item-03) (= (x-of-pull-0100c-solid-low-10 item-03) 9407) (= (y-of-pull-0100c-solid-low-10 item-03) 10221) (= (cost-of-pull-0100c-solid-low-10 item-03) 11)
    (can-pull-0110c-solid-low-10 item-03) (= (x-of-pull-0110c-solid-low-10 item-03) 9690) (= (y-of-pull-0110c-solid-low-10 item-03) 9941) (= (cost-of-pull-0110c-solid-low-10 item-03) 7)
    (can-pull-left-1110c-solid-low-10 item-03) (= (x-of-pull-left-1110c-solid-low-10 item-03) 9582) (= (y-of-pull-left-1110c-solid-low-10 item-03) 10303) (= (cost-of-pull-left-1110c-solid-low-10 item-03) 4)
    (can-push-forward-0101c-solid-low-10 item-03) (= (x-of-push-forward-0101c-solid-low-10 item-03) 10396) (= (y-of-push-forward-0101c-solid-low-10 item-03) 9788) (= (cost-of-push-forward-0101c-solid-low-10 item-03) 14)
    (can-push-forward-1011-solid-low-10 item-03) (= (x-of-push-forward-1011-solid-low-10 item-03) 10826) (= (y-of-push-forward-1011-solid-low-10 item-03) 10069) (= (cost-of-push-forward-1011-solid-low-10 item-03) 4)
    (can-push-forward-left-1001c-solid-low-10 item-03) (= (x-of-push-forward-left-1001c-solid-low-10 item-03) 10595) (= (y-of-push-forward-left-1001c-solid-low-10 item-03) 10724) (= (cost-of-push-forward-left-1001c-solid-low-10 item-03) 11)
    (can-push-forward-left-1010-solid-low-10 item-03) (= (x-of-push-forward-left-1010-solid-low-10 item-03) 10121) (= (y-of-push-forward-left-1010-solid-low-10 item-03) 10199) (= (cost-of-push-forward-left-1010-solid-low-10 item-03) 7)
    (can-push-forward-left-1100c-solid-low-10 item-03) (= (x-of-push-forward-left-1100c-solid-low-10 item-03) 10234) (= (y-of-push-forward-left-1100c-solid-low-10 item-03) 10740) (= (cost-of-push-forward-left-1100c-solid-low-10 item-03) 56)
    (can-push-forward-right-0111c-solid-low-10 item-03) (= (x-of-push-forward-right-0111c-solid-low-10 item-03) 10231) (= (y-of-push-forward-right-0111c-solid-low-10 item-03) 9494) (= (cost-of-push-forward-right-0111c-solid-low-10 item-03) 56)
    (can-push-forward-right-1111-solid-low-10 item-03) (= (x-of-push-forward-right-1111-solid-low-10 item-03) 10288) (= (y-of-push-forward-right-1111-solid-low-10 item-03) 9856) (= (cost-of-push-forward-right-1111-solid-low-10 item-03) 21)
    (can-push-left-1000-solid-low-10 item-03) (= (x-of-push-left-1000-solid-low-10 item-03) 9951) (= (y-of-push-left-1000-solid-low-10 item-03) 10178) (= (cost-of-push-left-1000-solid-low-10 item-03) 7)
    (can-push-right-0001b-solid-low-10 item-03) (= (x-of-push-right-0001b-solid-low-10 item-03) 9867) (= (y-of-push-right-0001b-solid-low-10 item-03) 9536) (= (cost-of-push-right-0001b-solid-low-10 item-03) 11)
    (= (x-of-push-right-0010-solid-low-10 item-03) 10084) (= (y-of-push-right-0010-solid-low-10 item-03) 9820) (= (cost-of-push-right-0010-solid-low-10 item-03) 7)
    (can-push-right-0011-solid-low-10 item-03) (= (x-of-push-right-0011-solid-low-10 item-03) 10102) (= (y-of-push-right-0011-solid-low-10 item-03) 9649) (= (cost-of-push-right-0011-solid-low-10 item-03) 87)
    (= (x-of-stay-1101-solid-low-10 item-03) 10000) (= (y-of-stay-1101-solid-low-10 item-03) 9939) (= (cost-of-stay-1101-solid-low-10 item-03) 11))
  (:goal (and
    ; item-01 shall come to (0.7273, 0.1361, 0.0124) m, 175 mm from where it starts
    (<= (x item-01) 4227) (>= (x item-01) 3317)
    (<= (+ (x item-01) (y item-01)) 8776) (>= (+ (x item-01) (y item-01)) 7489)
    (<= (y item-01) 4815) (>= (y item-01) 3906)
    (<= (y item-01) (+ (x item-01) 1232)) (<= (x item-01) (+ (y item-01) 55))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6594, -0.0528, 0.0211) m, 163 mm from where it starts
    (<= (x item-02) 3549) (>= (x item-02) 2639)
    (<= (+ (x item-02) (y item-02)) 6209) (>= (+ (x item-02) (y item-02)) 4922)
    (<= (y item-02) 2927) (>= (y item-02) 2017)
    (<= (y item-02) (+ (x item-02) 21)) (<= (x item-02) (+ (y item-02) 1266))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.8674, -0.1013, 0.0321) m, 383 mm from where it starts
    (<= (x item-03) 5630) (>= (x item-03) 4720)
    (<= (+ (x item-03) (y item-03)) 7806) (>= (+ (x item-03) (y item-03)) 6519)
    (<= (y item-03) 2442) (>= (y item-03) 1532)
    (<= (+ (y item-03) 2544) (x item-03)) (<= (x item-03) (+ (y item-03) 3831))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
