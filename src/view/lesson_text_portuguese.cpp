// The Portuguese words of the lesson pane.

#include "view/lesson_text.h"

namespace raywalk {

std::string_view portuguese(LessonWord word) {
  switch (word) {
    case LessonWord::lessons:
      return "Lições";
    case LessonWord::next:
      return "Próximo";
    case LessonWord::back:
      return "Voltar";
    case LessonWord::reveal:
      return "Revelar";
    case LessonWord::all_lessons:
      return "Todas as lições";
    case LessonWord::finish:
      return "Concluir";
    case LessonWord::presenter:
      return "Apresentador";
    case LessonWord::unlock:
      return "Liberar todas";
    case LessonWord::predict:
      return "Preveja";
    case LessonWord::drag_arrow:
      return "Arraste uma seta na planta";
    case LessonWord::type_number:
      return "Digite um número e Enter";
    case LessonWord::change:
      return "Agora mude algo";
    case LessonWord::teacher:
      return "Notas do professor";
    case LessonWord::right:
      return "Certo";
    case LessonWord::wrong:
      return "Ainda não";
    case LessonWord::error:
      return "erro de";
    case LessonWord::of:
      return "de";
    case LessonWord::locked:
      return "conclua a lição anterior";
    case LessonWord::done:
      return "concluída";
    case LessonWord::hands:
      return "{0} de {1} mãos acertaram";
    case LessonWord::hands_hint:
      return "Mãos levantadas: 1, 2, ... contam uma mão; com Shift, uma a menos";
    case LessonWord::hand_more:
      return "Mais uma mão";
    case LessonWord::hand_less:
      return "Menos uma mão";
    case LessonWord::score:
      return "previsões certas";
  }
  return {};
}

}  // namespace raywalk
